// `racebeam shake`: stalls between the units, and pictures that must stay what they are.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/program/command.h"
#include "tb/show/run.h"
#include "tb/twin/channels.h"

namespace racebeam {

struct ShakeCommandOptions : RunOptions, ShakeOptions {
  ShakeCommandOptions() { shake = "1"; }

  long long seeds = 4;    ///< that one, and those after it
  long long frames = 0;   ///< spread over the show; 0: as many as usual
  std::string at;         ///< a list of frames instead
  bool channels = false;  ///< list them instead
  bool json = false;
};

int command_shake(const ShakeCommandOptions& options);

Command shake_row();

}  // namespace racebeam
