// `racebeam view`: a show that runs in a window or a terminal.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tb/program/command.h"
#include "tb/show/run.h"
#include "tb/tt/tt_options.h"

namespace racebeam {

/// The command line as it was written.
struct ViewOptions : RunOptions, TtOptions {
  long long first = 0, scale = 0;
  std::optional<long long> frames;
  std::string keys;  ///< names with blanks between
  std::string folder = ".";
  bool paused = false;
  bool terminal = false;
  std::optional<long long> sound_pin;  ///< of uio_out of the chip of --tt; 7
  std::string record_inputs;           ///< file that gets them; empty: none
};

/// Runs until the user quits. Returns the exit code. Throws UsageError, MissingTool, RtlError,
/// OutputError, SyncError.
int command_view(const ViewOptions& options);

Command view_row();

}  // namespace racebeam
