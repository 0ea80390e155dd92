// `racebeam bench`: simulated clocks a second.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/program/command.h"
#include "tb/speed/chip_rows.h"

namespace racebeam {

struct BenchOptions : Effort {
  std::vector<std::string> rows;  ///< groups of rows, and units; empty: all
  bool json = false;
};

/// The groups of rows, and the units: what may be asked for.
std::vector<std::string> bench_rows();

/// Returns the exit code. Throws UsageError for an unknown row.
int command_bench(const BenchOptions& options);

Command bench_row();

}  // namespace racebeam
