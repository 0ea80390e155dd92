// The columns of a sweep's store: what is kept of a frame, as integers.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sc/base/engine.h"

namespace racebeam {

/// The engine's counters by name; of each of its histograms NAME.sum, of all values, and some
/// percentiles, NAME.p50; of each number of its lines NAME.sum, NAME.p99, NAME.max and NAME.never
/// (lines that it never came in); then the errors of its SweepKind, and the picture's digest.
std::vector<std::string> sweep_columns(const engine& built);

/// Their values in a frame with this picture. No errors: it was not judged, and has none.
std::vector<std::int64_t> column_values(const engine& built, const frame_counts& counts,
                                        std::vector<std::int64_t> errors,
                                        const std::vector<std::uint8_t>& colours);

/// Which values of a frame are none: NAME.p99 and NAME.max of a number that no line had. A row has
/// 0 there; render says null.
class NoValues {
 public:
  explicit NoValues(const std::vector<std::string>& columns);

  bool is_none(std::size_t column, const std::vector<std::int64_t>& values) const {
    const Sum& sum = sums_[column];
    return sum.never != 0 && values[sum.never] > 0 && values[sum.column] == 0;
  }
  /// The same in SQL, of a row `row`; "": it always is one.
  std::string is_some(std::size_t column, const std::string& row) const;

 private:
  struct Sum {
    std::size_t column = 0, never = 0;  // never is 0: not such a column
  };
  const std::vector<std::string> columns_;
  std::vector<Sum> sums_;
};

}  // namespace racebeam
