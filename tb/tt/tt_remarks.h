// What a user is told about a Tiny Tapeout chip beside its pictures.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/monitor/frame_finder.h"
#include "tb/monitor/vga_monitor.h"
#include "tb/tt/tt_project.h"

namespace racebeam {

/// What was assumed beside what the user named.
std::vector<std::string> assumptions(const TtProject& project, const FoundFrames& found);

/// What broke the video mode.
std::vector<std::string> complaints(const VgaFaults& faults);

}  // namespace racebeam
