// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/units.h"

#include <type_traits>

#include "sc/block/block_chip.h"

namespace racebeam {

namespace {

template <class Unit>
std::unique_ptr<sc_core::sc_module> make(const char* instance, const knob_values& values,
                                         const scene_tables*) {
  const block_knobs k = values;
  if constexpr (std::is_same_v<Unit, vga_timing>)
    return std::make_unique<Unit>(instance, block_knobs::clocks_per_pixel);
  else if constexpr (std::is_constructible_v<Unit, const char*, const block_knobs&>)
    return std::make_unique<Unit>(instance, k);
  else return std::make_unique<Unit>(instance, k.store());
}

template <class Unit>
constexpr unit_row row(const char* place = "") {
  return {Unit::unit_name, Unit::unit_name, unit_row::Always, make<Unit>, place};
}

}  // namespace

const std::vector<unit_row>& block_unit_table() {
  static const std::vector<unit_row> table = {
      row<block_convert>(), row<block_scheduler>(), row<block_core>("g_core[0]."),
      row<block_bus>(),     row<write_buffer>(),    row<store_arbiter>(),
      row<vga_timing>(),    row<frame_scanout>(),
  };
  return table;
}

}  // namespace racebeam
