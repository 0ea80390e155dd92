// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_shade_core.h"

namespace racebeam {

int voxel_shade_core::colour(const inputs& in, const voxel_knobs& k) const {
  if (kind_q == VoxelSky) return voxel_sky_colour(in.direction_z, k);
  if (!voxel_shows_column(kind_q, k)) return voxel_limit_colour(kind_q);
  constexpr int FullLight = 16;
  const int index = voxel_palette_index(unpacked_column(column_q), surface(in), k.size_z);
  return voxel_lit(palette_q[static_cast<std::size_t>(index)],
                   k.shading == VoxelShadingSlope ? voxel_light_of(slope_q) : FullLight,
                   shadowed_q);
}

std::uint32_t voxel_shade_core::address(const voxel_knobs& k) const {
  const auto place = [](int cell, bool more, bool less, int size) {
    return static_cast<std::uint32_t>(
        voxel_wrapped(wrap_signed(cell + more - less, VoxelCoordinateBits), size));
  };
  return place(cell_q[1], step_q == North, step_q == South, k.size_y) *
             static_cast<std::uint32_t>(k.size_x) +
         place(cell_q[0], step_q == East, step_q == West, k.size_x);
}

voxel_shade_core::outputs voxel_shade_core::comb(const inputs& in, const voxel_knobs& k) const {
  outputs o{};
  o.read = reads() ? phase_q == 0 : in.leaf_read;
  o.address = reads() ? address(k) : in.leaf_address;
  o.done = step_q == Last;
  o.colour = colour(in, k);
  return o;
}

int voxel_shade_core::next_step(const voxel_knobs& k) const {
  if (step_q == Idle && voxel_reads_own(kind_q, k)) return Own;
  if (step_q < East)
    return k.shading == VoxelShadingSlope && voxel_shows_column(kind_q, k) ? East : Last;
  return step_q + 1;
}

void voxel_shade_core::take_column(const inputs& in) {
  const int height = voxel_slope_height(unpacked_column(in.data), surface(in).upper);
  switch (step_q) {
    case Own: column_q = in.data; break;
    case East: slope_q += 2 * height; break;
    case West: slope_q -= 2 * height; break;
    case North: slope_q += height; break;
    default: slope_q -= height; break;
  }
}

void voxel_shade_core::clock(const inputs& in, const voxel_knobs& k) {
  const bool begins = step_q == Idle && in.shade;
  const bool last_of_read = reads() && phase_q == 1 + k.memory_clocks;
  if (last_of_read) take_column(in);
  if (in.take) {
    kind_q = in.kind;
    for (std::size_t axis = 0; axis < 3; ++axis)
      cell_q[axis] = in.hit[axis] >> VoxelPositionFraction;
    column_q = in.data;
  }
  phase_q = reads() && !last_of_read ? phase_q + 1 : 0;
  if (begins) {
    slope_q = 0;
    shadowed_q = in.shadowed;
  }
  if (begins || last_of_read) step_q = next_step(k);
  else if (step_q == Last && in.put_ready) step_q = Idle;
  if (in.palette_write) palette_q[static_cast<std::size_t>(in.palette_index)] = in.palette_colour;
  if (!in.rst_n) {
    step_q = Idle;
    phase_q = 0;
  }
}

}  // namespace racebeam
