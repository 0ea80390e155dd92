// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_builder_core.h"

namespace racebeam {

bool voxel_builder_core::solid() const {
  const int bits = levels.voxel_bits()[2];
  const int z = z_q << bits;
  return z < low_q || (middle_q < high_q && z + (1 << bits) > middle_q && z < high_q);
}

// Of the voxel, or of the child that is looked at.
voxel_place voxel_builder_core::place() const {
  const vec3& bits = levels.voxel_bits();
  if (state_q == VoxelBuilderFill) return levels.place(0, x_q >> bits[0], y_q >> bits[1], z_q);
  if (!looks()) return levels.place(level_q, x_q, y_q, z_q);
  return levels.place(level_q - 1, 2 * x_q + (child_q & 1), 2 * y_q + (child_q >> 1 & 1),
                      2 * z_q + (child_q >> 2));
}

// Where x and y begin and end.
voxel_rectangle voxel_builder_core::limits() const {
  if (state_q != VoxelBuilderFill) return area_q;
  const vec3& bits = levels.voxel_bits();
  return {area_q.x_low << bits[0], area_q.y_low << bits[1], area_q.x_high << bits[0],
          area_q.y_high << bits[1]};
}

bool voxel_builder_core::last() const {
  const voxel_rectangle to = limits();
  return z_q == levels.level(level_q).sides[2] - 1 && x_q == to.x_high - 1 && y_q == to.y_high - 1;
}

voxel_builder_core::outputs voxel_builder_core::comb(const inputs& in, const voxel_knobs& k) const {
  outputs o{};
  if (state_q == VoxelBuilderIdle) {
    o.done = true;
    o.column_read = in.leaf_read && !in.host_write;
    o.column_write = in.host_write;
    o.column_address = in.host_write ? in.host_address : in.leaf_address;
    o.occupancy_read = in.walk_read;
    o.occupancy_address = in.walk_address;
    return o;
  }
  const int last_state = levels.count() > 1 ? VoxelBuilderUp : VoxelBuilderFill;
  o.done = state_q == last_state && level_q == levels.count() - 1 && leaves(k) && last();
  o.column_read = fetches() && phase_q == 0;
  o.column_address = static_cast<std::uint32_t>(y_q * levels.size()[0] + x_q);
  const voxel_place at = place();
  o.occupancy_read = (puts_q || looks()) && phase_q == 0;
  o.occupancy_write = puts_q && ends(k);
  o.occupancy_address = at.word;
  const std::uint32_t bit = 1u << at.bit;
  const bool set = state_q == VoxelBuilderFill || (state_q == VoxelBuilderUp && found_q);
  o.occupancy_data = set ? in.occupancy | bit : in.occupancy & ~bit;
  return o;
}

// x and y at their low limits.
void voxel_builder_core::begin(int state, int level, const voxel_rectangle& area) {
  state_q = state;
  level_q = level;
  area_q = area;
  x_q = limits().x_low;
  y_q = limits().y_low;
}

// To the next voxel, z first, then x, then y; to the next level; to the next part.
void voxel_builder_core::go_on() {
  const voxel_rectangle to = limits();
  const bool top = z_q == levels.level(level_q).sides[2] - 1;
  const bool all = last();
  known_q = state_q == VoxelBuilderFill && !top;
  if (state_q == VoxelBuilderFill && top) ++columns_q;
  z_q = top ? 0 : z_q + 1;
  if (all) {
    const voxel_rectangle above{area_q.x_low >> 1, area_q.y_low >> 1, (area_q.x_high + 1) >> 1,
                                (area_q.y_high + 1) >> 1};
    if (state_q == VoxelBuilderClear) begin(VoxelBuilderFill, 0, area_q);
    else if (level_q + 1 < levels.count()) begin(VoxelBuilderUp, level_q + 1, above);
    else state_q = VoxelBuilderIdle;
  } else if (top) {
    const bool row = x_q == to.x_high - 1;
    x_q = row ? to.x_low : x_q + 1;
    y_q += row;
  }
  puts_q = state_q == VoxelBuilderClear;
}

void voxel_builder_core::clock(const inputs& in, const voxel_knobs& k) {
  if (takes(in)) {
    begin(VoxelBuilderClear, 0, voxel_aligned(in.rectangle, levels, 0));
    known_q = found_q = false;
    puts_q = true;
    phase_q = z_q = child_q = 0;
    columns_q = 0;
  } else if (state_q != VoxelBuilderIdle) {
    const bool accesses = !compares(), over = ends(k);
    if (accesses && over && fetches()) {
      const voxel_column c = unpacked_column(in.column);
      low_q = c.low;
      middle_q = c.middle;
      high_q = c.high;
      known_q = true;
    } else if (accesses && over && looks()) {
      found_q = in.occupancy >> place().bit & 1;
      puts_q = found_q || child_q == 7;
      child_q = puts_q ? 0 : child_q + 1;
    } else if (leaves(k)) {
      go_on();
    } else if (compares()) {
      puts_q = true;
    }
    phase_q = accesses && !over ? phase_q + 1 : 0;
  }
  if (!in.rst_n) {
    state_q = VoxelBuilderIdle;
    columns_q = 0;
  }
}

}  // namespace racebeam
