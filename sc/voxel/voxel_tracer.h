// voxel_tracer: voxel_scan and what it drives, from voxel_camera to voxel_shade, pixel by pixel,
// without SystemC: the base of the tlm level. The same colours and clocks as the units.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/voxel/counters.h"
#include "sc/voxel/voxel_rays.h"
#include "sc/voxel/voxel_tables.h"

namespace racebeam {

struct voxel_drawn {
  voxel_end end;  ///< of the ray from the eye
  bool shadowed;  ///< the light does not reach it
  int colour;     ///< RGB888
  int clocks;     ///< until it is put, that clock among them, waiting not
};

/// The direction of a pixel's ray, 2.16.
vec3 voxel_direction(const voxel_view& view, int x, int y);

class voxel_tracer {
 public:
  /// All outlive it.
  voxel_tracer(const voxel_knobs& k, const voxel_world& world, const voxel_palette& palette)
      : k_(k), world_(world), palette_(palette) {}

  /// Adds what a pixel costs, but for `clocks`.
  voxel_drawn draw(const voxel_view& view, int x, int y, voxel_counters& n) const;

 private:
  const voxel_knobs& k_;
  const voxel_world& world_;
  const voxel_palette& palette_;
};

}  // namespace racebeam
