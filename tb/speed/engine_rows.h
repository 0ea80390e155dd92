// What `racebeam bench` runs of each engine, so that they can be compared: its built-in scene, all
// models, at each of its levels.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/engine.h"

namespace racebeam {

struct EngineLevel {
  const engine& built;
  std::string level;

  /// "sphere: signal"
  std::string name() const { return std::string(built.name) + ": " + level; }
};

/// The levels of the first engine, those of the next ...
std::vector<EngineLevel> engine_levels();

/// A row: clocks a second. At the level `signal` so many clocks as a user waits for, else pictures.
void register_engine(const EngineLevel& row, int repeats);

}  // namespace racebeam
