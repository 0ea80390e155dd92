// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/units.h"

#include <type_traits>

#include "sc/voxel/voxel_chip.h"

namespace racebeam {

namespace {

template <class Unit>
std::unique_ptr<sc_core::sc_module> make(const char* instance, const knob_values& values,
                                         const scene_tables*) {
  const voxel_knobs k = values;
  if constexpr (std::is_same_v<Unit, vga_timing>)
    return std::make_unique<Unit>(instance, voxel_knobs::clocks_per_pixel);
  else if constexpr (std::is_constructible_v<Unit, const char*, const voxel_knobs&>)
    return std::make_unique<Unit>(instance, k);
  else if constexpr (std::is_constructible_v<Unit, const char*, const store_knobs&>)
    return std::make_unique<Unit>(instance, k.store());
  else return std::make_unique<Unit>(instance);
}

template <class Unit>
constexpr unit_row row() {
  return {Unit::unit_name, Unit::unit_name, unit_row::Always, make<Unit>};
}

}  // namespace

const std::vector<unit_row>& voxel_unit_table() {
  static const std::vector<unit_row> table = {
      row<voxel_builder>(), row<voxel_scan>(),   row<voxel_camera>(),  row<voxel_walker>(),
      row<voxel_setup>(),   row<voxel_limits>(), row<voxel_address>(), row<voxel_leaf>(),
      row<voxel_shade>(),   row<write_buffer>(), row<store_arbiter>(), row<vga_timing>(),
      row<frame_scanout>(),
  };
  return table;
}

}  // namespace racebeam
