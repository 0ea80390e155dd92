// The shots of a scene as the table that rtl/timeline.sv reads.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sc/scene_program.h"

namespace racebeam {

/// One line for each shot and one for the end, as the head of rtl/timeline.sv says.
std::string shot_table(const scene_program& program);

}  // namespace racebeam
