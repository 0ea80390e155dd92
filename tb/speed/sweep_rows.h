// What `racebeam bench sweep` measures: how near sweeps are to their goals, each a number of one
// run, most of them ratios.
//
// Processor seconds of all processes are what counts, but for two cores against one, and the least
// of several runs: other work on the machine only adds.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace racebeam {

struct GoalRow {
  std::string name;
  std::string unit;  ///< "x": a ratio
  double value = 0, goal = 0;
  bool at_least = false;  ///< the goal is a least value, not a largest one

  bool met() const { return at_least ? value >= goal : value <= goal; }
};

/// What may be measured alone: points, cores, ...
std::vector<std::string> sweep_parts();

/// Measures a part and calls `row` for each row as it comes; each time that is compared is the
/// least of so many runs. Writes into a folder of its own. What needs yosys, or a second core, is
/// left out where that is missing, which is told. Throws what sweeps throw.
void measure_sweeps(const std::string& part, int repeats,
                    const std::function<void(const GoalRow&)>& row);

}  // namespace racebeam
