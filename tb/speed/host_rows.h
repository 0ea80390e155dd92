// What `racebeam bench` runs of the program itself: rows in seconds, not in clocks.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/speed/chip_rows.h"

namespace racebeam {

/// From the start of this program to its end, when it only says its version.
void register_start(int repeats);

/// The bytes of a frame's PNG, a mean of frames evenly spread over the demo.
void register_png(const Effort& effort);

constexpr int HostRows = 2;

}  // namespace racebeam
