// `racebeam trace --tt`: a window of a Tiny Tapeout chip's signals as a waveform.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/trace/trace_options.h"

namespace racebeam {

/// Returns the exit code. Throws UsageError, RtlError, MissingTool, SyncError, OutputError.
int trace_tt(const TraceOptions& options);

}  // namespace racebeam
