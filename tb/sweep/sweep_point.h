// SweepPoint: one setting of all knobs, as a sweep asks for it, and the text that tells it from
// others.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/engine.h"

namespace racebeam {

/// The row of an engine's knob that a sweep may set: any but those of a scene file. Null: there is
/// none.
const knob_row* swept_knob(const engine& of, const std::string& name);
/// The names of all of them.
std::vector<std::string> swept_knobs(const engine& of);

struct SweepPoint {
  std::string name;  ///< "p31", or as the sweep file has it; "chip" for the base without one
  knob_values k;     ///< on what the engine has built in, settled
  std::vector<const knob_row*> set{};  ///< rows that the sweep sets; a scene may bring others

  int value_of(const knob_row& row) const;
  void set_knob(const knob_row& row, int value);
};

bool operator==(const SweepPoint& a, const SweepPoint& b);

/// The knobs of a point on a scene: what the sweep does not set is as in `standard`, those of
/// Show::standard_knobs().
knob_values knobs_on(const SweepPoint& point, const knob_values& standard);

/// The point's identity: all knobs by name, those of the scene too, "name=value\n". A default that
/// has changed makes another text.
std::string point_text(const knob_values& k);

}  // namespace racebeam
