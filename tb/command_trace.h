// `racebeam trace`: a window of the chip's signals or transactions as a waveform; two waveforms
// compared.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

/// The command line as it was written.
struct TraceOptions {
  std::string scene, output, from, to;
  std::string level = "signal";     ///< or "tlm": transactions
  std::string around;               ///< a trigger, or empty
  long long lines = 1;              ///< before and after it
  std::vector<std::string> scopes;  ///< patterns of paths
  long long depth = 0;
  std::vector<std::string> assignments, units;
  std::vector<std::string> diff;  ///< two files to compare instead of a scene
  bool shared = false;            ///< compare what both have
};

/// Returns the exit code. Throws UsageError, RtlError, MissingTool, OutputError.
int command_trace(const TraceOptions& options);

}  // namespace racebeam
