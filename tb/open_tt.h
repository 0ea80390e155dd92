// Tiny Tapeout projects named on the command line.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/tt_options.h"
#include "tb/tt_project.h"

namespace racebeam {

/// Frames of any chip: every one up to the last that is wanted is simulated.
constexpr int MostTtFrames = 1'000'000;

/// Throws UsageError.
TtProject open_tt_project(const TtOptions& options);

/// The plug-in of its chip, whose inputs pass a register; `signals`: those inside can be read.
/// Throws RtlError, MissingTool.
std::string tt_plugin(const TtProject& project, bool signals);

}  // namespace racebeam
