// Several units' RTL on the traffic of one pass over consecutive frames.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "tb/program/part_traffic.h"

namespace racebeam {

/// By unit, in a process of their own: the verdict of RTL that says what the model says. Nothing
/// for one that differs or ends, for models, and for all if one takes the process with it: these
/// are to be replayed alone, which tells why. `compared` is told in that process how many clocks
/// more are done. Seconds are those of the unit's RTL, and its share of making the traffic. Throws
/// Interrupted.
std::vector<std::optional<UnitVerdict>> replayed_together(
    const std::vector<ReplayUnit>& units, const ReplayPart& part,
    const std::function<void(std::uint64_t)>& compared);

}  // namespace racebeam
