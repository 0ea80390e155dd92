// `racebeam view --tt`: a Tiny Tapeout chip that runs in a window or a terminal.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/program/command_view.h"

namespace racebeam {

/// Runs until the user quits. Returns the exit code. Throws UsageError, MissingTool, RtlError,
/// OutputError, SyncError.
int view_tt(const ViewOptions& options);

}  // namespace racebeam
