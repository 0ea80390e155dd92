// A scene as the tables that rtl/beam/timeline.sv and rtl/beam/scene_rom.sv read; their heads have
// the layout.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sc/beam/scene_program.h"

namespace racebeam {

/// For timeline: one line for each shot and one for the end.
std::string shot_table(const scene_program& program);

/// For scene_rom: one line for each room.
std::string room_table(const scene_program& program);

}  // namespace racebeam
