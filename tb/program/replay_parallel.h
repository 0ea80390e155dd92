// Gates of several units on the traffic of up to 64 parts of a show at once.
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

/// By part, then by unit: the verdict of gates that say what the model says; nothing for those that
/// differ, which are to be replayed alone, for that tells how. Each part's traffic is made in a
/// process of its own. `compared` is told now and then how many clocks more of units are done. A
/// unit's seconds are shared by the parts. Throws RtlError, Interrupted; MissingTool if one of the
/// processes ends early.
std::vector<std::vector<std::optional<UnitVerdict>>> replayed_in_parallel(
    const std::vector<ReplayUnit>& units, const std::vector<ReplayPart>& parts,
    const std::function<void(std::uint64_t)>& compared);

}  // namespace racebeam
