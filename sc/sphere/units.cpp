// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/units.h"

#include <type_traits>

#include "sc/sphere/sphere_chip.h"

namespace racebeam {

namespace {

template <class Unit>
std::unique_ptr<sc_core::sc_module> make(const char* instance, const knob_values& values,
                                         const scene_tables* scene) {
  static const sphere_tables none;
  const sphere_knobs k = sphere_knobs(values).resolved();
  const auto& tables = scene ? *static_cast<const sphere_tables*>(scene) : none;
  if constexpr (std::is_same_v<Unit, vga_timing>)
    return std::make_unique<Unit>(instance, k.clocks_per_pixel);
  else if constexpr (std::is_constructible_v<Unit, const char*, const sphere_tables&>)
    return std::make_unique<Unit>(instance, tables);
  else if constexpr (std::is_constructible_v<Unit, const char*, const sphere_knobs&>)
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

const std::vector<unit_row>& sphere_unit_table() {
  static const std::vector<unit_row> table = {
      row<sphere_inputs>(), row<sphere_host_link>(), row<sphere_table>(), row<plane_table>(),
      row<sphere_raygen>(), row<vector_unit>(),      row<root_unit>(),    row<divider_unit>(),
      row<sphere_tracer>(), row<sphere_shader>(),    row<write_buffer>(), row<store_arbiter>(),
      row<vga_timing>(),    row<frame_scanout>(),
  };
  return table;
}

}  // namespace racebeam
