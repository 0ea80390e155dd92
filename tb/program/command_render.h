// `racebeam render`: frames of the demo as files and numbers.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/program/command.h"
#include "tb/render/render_options.h"

namespace racebeam {

/// Renders and writes. Returns the exit code: 0, or 130 after an interruption, with all whole
/// frames kept. Throws UsageError, OutputError; SyncError if the chip's pins break the
/// video mode, after writing what was good.
int command_render(const RenderOptions& options);

Command render_row();

}  // namespace racebeam
