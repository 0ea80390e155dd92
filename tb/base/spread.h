// Spread: least, mean, percentile and largest of many small numbers, in memory that does not grow
// with their count.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace racebeam {

class Spread {
 public:
  /// `value` is 0 or more.
  void add(int value);

  std::uint64_t count() const { return count_; }
  std::uint64_t sum() const { return sum_; }
  double mean() const { return static_cast<double>(sum_) / static_cast<double>(count_); }
  int min() const { return percentile(0); }
  int max() const { return static_cast<int>(times_.size()) - 1; }
  /// The least value that is not exceeded by `percent` of all. Only with count() > 0.
  int percentile(int percent) const;

 private:
  std::vector<std::uint64_t> times_;  // that a value was added
  std::uint64_t count_ = 0, sum_ = 0;
};

}  // namespace racebeam
