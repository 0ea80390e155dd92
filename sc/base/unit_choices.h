// What each unit of the chip is made of: its model, its RTL, or both side by side.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

namespace racebeam {

struct unit_choice {
  enum implementation { Model, Rtl };
  implementation driver = Model;  ///< drives the unit's wires
  bool lockstep = false;          ///< the RTL runs beside the model and is compared with it
  std::string plugin;             ///< of the RTL
  std::string island{};           ///< instead, the plug-in of an rtl_island that the unit is in
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

}  // namespace racebeam
