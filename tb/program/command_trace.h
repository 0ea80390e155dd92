// `racebeam trace`: a window of the chip's signals or transactions as a waveform; two waveforms
// compared.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/program/command.h"
#include "tb/trace/trace_options.h"

namespace racebeam {

/// Returns the exit code. Throws UsageError, RtlError, MissingTool, OutputError.
int command_trace(const TraceOptions& options);

Command trace_row();

}  // namespace racebeam
