// `racebeam bench`: simulated clocks a second.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

struct BenchOptions {
  std::vector<std::string> rows;  ///< groups of rows, and units; empty: all
  int frames = 20;                ///< of each demo part
  int repeats = 5;                ///< of which the median counts
  bool json = false;
};

/// Returns the exit code. Throws UsageError for an unknown row.
int command_bench(const BenchOptions& options);

}  // namespace racebeam
