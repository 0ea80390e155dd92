// What comparisons of model and RTL are told of the units, one row for each engine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sc/base/engine.h"
#include "tb/twin/legal_inputs.h"
#include "tb/twin/plugin_maker.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

/// A unit alone on its way through what random traffic does not reach.
struct UnitWalk {
  const char* unit;
  const char* where;  ///< "through its tune"
  std::uint64_t clocks;
  /// What drives new values for the next clock; the same seed makes the same traffic.
  std::function<void()> (*begin)(UnitBench& bench, const knob_values& k, unsigned seed);
};

struct Twins {
  const racebeam::engine& engine;
  /// Plug-ins for chips with the knobs `k` that show `scene`, which must outlive the maker;
  /// nullptr: the built-in demo. `traced`: signals inside the RTL can be read.
  PluginMaker (*plugins)(const knob_values& k, const scene_tables* scene, bool traced);
  /// What can come to a unit of a chip with the knobs `k` that shows `scene`; nullptr: its own.
  LegalInputs (*inputs)(const knob_values& k, const scene_tables* scene, const std::string& unit);
  /// Whether engine::top with its own parameters is such a chip.
  bool (*is_top)(const knob_values& k, const scene_tables* scene);
  std::vector<UnitWalk> walks;
  /// Whether units that are used in RTL and touch each other become islands, and which of them have
  /// a back door.
  bool has_islands = false;
  std::vector<std::string> back_doors = {};

  /// nullptr: it has none.
  const UnitWalk* walk(const std::string& unit) const;
};

const std::vector<Twins>& twins();

/// The row of an engine. Throws std::out_of_range.
const Twins& twins_of(const engine& built);

}  // namespace racebeam
