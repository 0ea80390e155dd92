// Guard frames: the worst frames of the base point, which a sample may miss.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tb/sweep/store_notes.h"

namespace racebeam {

/// At most `count` frames, in order: half of them have the longest busy line, the others the most
/// starved pixels; of equal ones the first.
std::vector<int> worst_frames(std::vector<ScannedFrame> frames, int count);

}  // namespace racebeam
