// The synthesis of units by yosys, several at once.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tb/sweep/silicon.h"
#include "tb/sweep/store_caches.h"
#include "tb/verilate/run_tool.h"

namespace racebeam {

/// What became of a unit: its figures, or why there are none.
struct UnitOutcome {
  std::optional<UnitSilicon> silicon;
  std::string fault;  ///< "stacks with FaceStackDepth=15: yosys did not end within 300 seconds"
};

struct SynthesisPlan {
  int jobs = 1;
  std::chrono::milliseconds limit = std::chrono::minutes(5);  ///< of each unit, then it has failed
  std::function<void()> tick{};                               ///< called some ten times a second
};

/// Why there are no figures of a run, by what `tool` did or said: "yosys did not end within 300
/// seconds".
std::string fault_of(const ToolResult& result, std::chrono::milliseconds limit, const char* tool);

/// Runs all of them, and calls `done` for each in the order in which they end. Nothing that was
/// started lives on, whatever `done` throws. Throws MissingTool, Interrupted, RtlError if nothing
/// can be written to the cache folder.
void synthesise(const std::vector<UnitParameters>& units, const SynthesisPlan& plan,
                const std::function<void(const UnitParameters&, const UnitOutcome&)>& done);

}  // namespace racebeam
