// `racebeam explain`: why a pixel is as it is, down to the clocks that made it; figures of what the
// tracer computes for it; and the words for all that.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>

#include "tb/program/command.h"
#include "tb/show/run.h"

namespace racebeam {

/// The command line as it was written.
struct ExplainOptions : RunOptions {
  static constexpr long long NoFrame = std::numeric_limits<long long>::min();
  long long frame = NoFrame;  ///< NoFrame: not given
  std::string pixel;          ///< "X,Y"; empty: not given
  std::string figure, output;
  std::string word;
  bool words = false;
  bool json = false;
};

/// Returns the exit code. Throws UsageError, OutputError.
int command_explain(const ExplainOptions& options);

Command explain_row();

}  // namespace racebeam
