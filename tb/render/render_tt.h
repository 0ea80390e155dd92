// `racebeam render --tt`: a Tiny Tapeout chip instead of this project's.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/render/render_options.h"

namespace racebeam {

/// Returns the exit code. Throws UsageError, RtlError, MissingTool, SyncError and OutputError;
/// whole frames are kept.
int render_tt(const RenderOptions& options);

}  // namespace racebeam
