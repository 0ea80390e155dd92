// What a waveform can be centred on.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sc/beam/knobs.h"
#include "sc/beam/scene_program.h"
#include "tb/trace/trace_window.h"

namespace racebeam {

/// "first-starved": the beam finds the FIFO empty on a visible line. "first-restart": the tracer
/// starts again from the top of the tree before the line is done. "max-stack": most entries on the
/// interval stack, the first time.
const std::vector<std::string>& trigger_names();

/// The clock of `searched` in which it happens, found with the cores alone. `program`: nullptr is
/// the built-in demo. After each line `goes_on` is asked with the clocks that were simulated; if it
/// does not, nothing is found. Throws UsageError for an unknown name.
std::optional<TracePoint> find_trigger(const std::string& name, const TraceWindow& searched,
                                       const knobs& k, const Raster& raster,
                                       const scene_program* program,
                                       const std::function<bool(std::int64_t)>& goes_on);

}  // namespace racebeam
