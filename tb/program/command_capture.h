// `racebeam capture`: the traffic of a unit's ports into a file.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/program/command.h"
#include "tb/show/run.h"

namespace racebeam {

struct CaptureOptions : RunOptions {
  CaptureOptions() { scene = "demo"; }

  static constexpr long long Spread = -1;
  std::string unit;
  long long first = Spread;  ///< of consecutive frames; Spread: over the scene, as verify does
  long long frames = 1;      ///< or pictures
  long long random = 0;      ///< clocks of random traffic instead
  bool walk = false;         ///< the unit's walk instead
  long long seed = 1;
  std::string file;
};

/// Throws UsageError, OutputError, Interrupted.
int command_capture(const CaptureOptions& options);

Command capture_row();

}  // namespace racebeam
