// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/units.h"

#include <stdexcept>
#include <type_traits>

#include "sc/beam/chip.h"
#include "sc/beam/engine.h"

namespace racebeam {

namespace {

template <class Unit>
std::unique_ptr<sc_core::sc_module> make(const char* instance, const knob_values& values,
                                         const scene_tables* scene) {
  const knobs k = values;
  const auto* program = static_cast<const scene_program*>(scene);
  if constexpr (std::is_constructible_v<Unit, const char*, const knobs&, const scene_program&>)
    return std::make_unique<Unit>(instance, k, *program);
  else if constexpr (std::is_constructible_v<Unit, const char*, const scene_program&>)
    return std::make_unique<Unit>(instance, *program);
  else if constexpr (std::is_constructible_v<Unit, const char*, const knobs&>)
    return std::make_unique<Unit>(instance, k);
  else return std::make_unique<Unit>(instance);
}

template <>
std::unique_ptr<sc_core::sc_module> make<vga_timing>(const char* instance,
                                                     const knob_values& values,
                                                     const scene_tables*) {
  return std::make_unique<vga_timing>(instance, knobs(values).clocks_per_pixel);
}

template <class Unit, class Slot = Unit>
constexpr unit_row row(unit_row::use shows = unit_row::Always) {
  return {Unit::unit_name, Slot::unit_name, shows, make<Unit>};
}

}  // namespace

const std::vector<unit_row>& unit_table() {
  static const std::vector<unit_row> table = {
      row<vga_timing>(),
      row<sequencer>(unit_row::Demo),
      row<timeline, sequencer>(unit_row::SceneFile),
      row<camera_unit>(),
      row<ray_stepper>(),
      row<subdivider>(),
      row<stacks>(),
      row<decision_datapath>(),
      row<scene>(unit_row::Demo),
      row<scene_rom, scene>(unit_row::SceneFile),
      row<navigator>(),
      row<interval_fifo>(),
      row<pixel_output>(),
      row<pwm_sound>(),
  };
  return table;
}

const unit_row& unit_named(const std::string& name) {
  if (const unit_row* row = beam_engine().unit(name)) return *row;
  throw std::out_of_range("there is no unit " + name);
}

std::vector<std::string> chip_units(bool scene_file) {
  return beam_engine().unit_names(scene_file);
}

std::string instance_of(const std::string& unit) { return unit_named(unit).instance(); }

}  // namespace racebeam
