// A unit that is verified, and what its twins are made for.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sc/base/engine.h"

namespace racebeam {

struct UnitUnderTest {
  std::string unit, plugin;  ///< plugin: empty for the unit's own RTL
  knob_values k;
  const scene_tables* scene;  ///< for units that show scene files
  int frames;                 ///< of the show
};

}  // namespace racebeam
