// SweepPoint: one setting of all knobs, as a sweep asks for it, and the text that tells it from
// others.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/beam/knobs.h"

namespace racebeam {

/// The row of a knob that a sweep may set: any but those of a scene file. Null: there is none.
const knob_info* swept_knob(const std::string& name);
/// The names of all of them.
std::vector<std::string> swept_knobs();

struct SweepPoint {
  std::string name;  ///< "p31", or as the sweep file has it; "chip" for the base without one
  knobs k;           ///< on the built-in demo; max_room_depth is what counts
  std::vector<const knob_info*> set{};  ///< rows that the sweep sets; a scene may bring others

  void set_knob(const knob_info& row, int value);
};

bool operator==(const SweepPoint& a, const SweepPoint& b);

/// The knobs of a point on a scene: what the sweep does not set is as in `standard`, those of
/// Show::standard_knobs().
knobs knobs_on(const SweepPoint& point, const knobs& standard);

/// The point's identity: all knobs by name, those of the scene too, "name=value\n". A default that
/// has changed makes another text.
std::string point_text(const knobs& k);

}  // namespace racebeam
