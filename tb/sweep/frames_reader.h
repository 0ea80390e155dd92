// [frames] of a sweep file: how many frames of a point, and which.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tb/scene/toml_tree.h"
#include "tb/sweep/goal_reader.h"
#include "tb/sweep/sweep_file.h"

namespace racebeam {

void read_frames(const TomlNode& node, const std::vector<SweepFigure>& figures, SweepFrames& frames,
                 Faults& faults);

}  // namespace racebeam
