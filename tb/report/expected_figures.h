// Figures that a comparison is expected to have, in a file: `racebeam compare --expect`.
//
// A line each: GROUP ENGINE FIGURE VALUE TOLERANCE, as "common/balls block clocks_per_pixel 8.19
// 1%". VALUE may be "exact" (nothing differs) or "-" (the engine does not have it); TOLERANCE is a
// number or a share of the value. Blanks in the name of a group are written as "_"; what follows #
// is a remark.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/report/comparison.h"

namespace racebeam {

class ExpectedFigures {
 public:
  /// Throws UsageError with place: no such file, figure or form.
  explicit ExpectedFigures(const std::string& path);

  /// A line for each figure that is not as expected. Throws UsageError if one was not compared.
  std::vector<std::string> faults(const std::vector<ComparedGroup>& groups) const;

 private:
  struct Row {
    int line;
    std::string group, engine, figure, value;
    double number, tolerance;
  };
  std::string place(const Row& row) const;
  Row row_of(int line, const std::vector<std::string>& words) const;

  const std::string path_;
  std::vector<Row> rows_;
};

}  // namespace racebeam
