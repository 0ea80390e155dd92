// voxel_colour: what a pixel looks like, as plain functions; and voxel_shade in closed form, with
// its reads and clocks.
//
// Source: article "Termination", "Future work".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "sc/base/fixed_point.h"
#include "sc/voxel/codes.h"
#include "sc/voxel/knobs.h"
#include "sc/voxel/voxel_world.h"

namespace racebeam {

/// Colours of material * 16 + height: red, green, blue of 8 bits, blue lowest.
using voxel_palette = std::array<int, VoxelPaletteEntries>;

/// The solid of a column that is shown.
struct voxel_surface {
  bool upper = false;  ///< from middle to high; else below low
  int height = 0;      ///< of its cell that is the nearest to the ray's end
};

/// Of the column that a ray ended in, or above, at height `z` in whole units, going `down` or not.
/// A ray that ends at a border of the solid may be a unit beside it.
voxel_surface voxel_surface_of(const voxel_column& column, int z, bool down);
/// The height that counts for the slope beside such a surface.
constexpr int voxel_slope_height(const voxel_column& column, bool upper) {
  return upper ? column.high : column.low;
}
/// Where the palette has a surface's colour.
int voxel_palette_index(const voxel_column& column, const voxel_surface& surface, int size_z);

/// Sixteenths of the palette's colour, `slope` = 2 (east - west) + (north - south).
int voxel_light_of(int slope);
/// A colour in so many sixteenths of its light, and half of that in a shadow.
int voxel_lit(int colour, int sixteenths, bool shadowed);
/// By the direction's z, 2.16.
int voxel_sky_colour(int direction_z, const voxel_knobs& k);
/// Of a ray that a limit stopped, with debug_limits: magenta, of the inner limit half as bright.
constexpr int voxel_limit_colour(int kind) { return kind == VoxelOuterLimit ? 0xff00ff : 0x7f007f; }

/// A ray that ended so shows a column.
constexpr bool voxel_shows_column(int kind, const voxel_knobs& k) {
  return kind == VoxelHit || (kind != VoxelSky && !k.debug_limits);
}
/// Its column has to be read: the walker did not.
constexpr bool voxel_reads_own(int kind, const voxel_knobs& k) {
  return kind == VoxelHit && k.leaf == VoxelLeafVoxel;
}

/// A ray of a picture that ended.
struct voxel_pixel {
  voxel_kind kind = VoxelSky;
  vec3 position{};      ///< 16.8; of the sky: any
  int direction_z = 0;  ///< 2.16
  bool shadowed = false;
};
/// What shading it makes.
struct voxel_shaded {
  int colour;
  int reads;   ///< of columns
  int clocks;  ///< if the colour does not have to wait
};
voxel_shaded voxel_shade_pixel(const voxel_world& world, const voxel_palette& palette,
                               const voxel_knobs& k, const voxel_pixel& pixel);

}  // namespace racebeam
