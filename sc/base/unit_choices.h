// What each unit of the chip is made of: its model, its RTL, or both side by side.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

namespace racebeam {

struct unit_choice {
  enum implementation { Model, Rtl };
  implementation driver = Model;  ///< drives the unit's wires
  bool lockstep = false;          ///< the RTL runs beside the model and is compared with it
  std::string plugin;             ///< of the RTL
};

/// By unit; units that are not named are models.
struct unit_choices {
  std::map<std::string, unit_choice> by_unit;

  const unit_choice& of(const std::string& unit) const {
    static const unit_choice model;
    const auto at = by_unit.find(unit);
    return at == by_unit.end() ? model : at->second;
  }
};

/// The units of the chip, in the order of the contract. For a scene file timeline and scene_rom
/// take the places of sequencer and scene.
inline std::vector<std::string> chip_units(bool scene_file) {
  return {"vga_timing",        scene_file ? "timeline" : "sequencer",
          "camera_unit",       "ray_stepper",
          "subdivider",        "stacks",
          "decision_datapath", scene_file ? "scene_rom" : "scene",
          "navigator",         "interval_fifo",
          "pixel_output",      "pwm_sound"};
}

/// All units wired in RTL: only beside the chip, in lockstep.
constexpr const char* WholeChip = "racebeam_top";

/// Name of the instance that a unit is in chip.
inline std::string instance_of(const std::string& unit) {
  return "u_" + (unit == "timeline" ? "sequencer" : unit == "scene_rom" ? "scene" : unit);
}

}  // namespace racebeam
