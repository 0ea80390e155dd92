// The chip of a Tiny Tapeout project as a plug-in, if it may be trusted.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/tt/tt_project.h"

namespace racebeam {

/// The path of the plug-in; verilated when first needed. `signals`: those inside can be read. Cells
/// of sky130_fd_sc_hd that the project names and does not define are at hand. Unless `trust`, RTL
/// is refused that runs commands, writes files, or reads files outside of the folder. Tells
/// circular logic. Throws UsageError with file and line of that, RtlError, MissingTool.
std::string tt_plugin(const TtProject& project, bool trust, bool signals = false);

}  // namespace racebeam
