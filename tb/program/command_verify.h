// `racebeam verify`: model and RTL in lockstep, on the chip's traffic and on random traffic.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>

#include "tb/program/command.h"
#include "tb/show/run.h"
#include "tb/twin/channels.h"
#include "tb/twin/delays.h"

namespace racebeam {

/// `units`: UNIT, UNIT=FILE or all; none: all.
struct VerifyOptions : RunOptions, ShakeOptions, DelayOptions {
  VerifyOptions() { scene = "demo"; }

  /// Of the scene, evenly spread; 0: no chip traffic; UsualFrames: 60, or 2 whole pictures of an
  /// engine that does not race the beam.
  static constexpr long long UsualFrames = std::numeric_limits<long long>::min();
  static constexpr long long Spread = -1;
  long long frames = UsualFrames;
  long long random = 100000;  ///< clocks of random traffic for each unit
  long long seed = 1;
  std::string folder = "racebeam_verify";  ///< for waveforms of differences
  std::string stream;                      ///< file that is all that is played; empty: none
  std::string bench;                       ///< Verilog file of what the unit is played; empty: none
  bool no_shrink = false;                  ///< differences alone stay as they were found
  std::string replay;                      ///< a file of traffic, instead of frames and random
  long long first = Spread;  ///< of consecutive frames of a replay of all; Spread: over the scene
  std::string record;        ///< file for a row of each unit's replay; empty: none
  long long jobs = 0;        ///< processes of a replay of all; 0: as processors
  long long minutes = 0;     ///< after which no part of it begins; 0: no end
  long long power_up = 0;    ///< random values of each unit's registers at power-up
  bool watch = false;        ///< for verify_watch()
  bool json = false;
};

/// What is to be compared, but for the RTL. Throws UsageError; OutputError if the folder for
/// waveforms cannot be written.
Run plan_verify(const VerifyOptions& options);

/// Prints a table of units. Returns ExitUsage if RTL has ended before its
/// comparison, otherwise ExitDifference if one differs. Throws UsageError, RtlError,
/// MissingTool.
int command_verify(const VerifyOptions& options);

Command verify_row();

}  // namespace racebeam
