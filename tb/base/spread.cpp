// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/spread.h"

#include <algorithm>

namespace racebeam {

void Spread::add(int value) {
  const auto index = static_cast<std::size_t>(value);
  if (index >= times_.size()) times_.resize(index + 1);
  ++times_[index];
  ++count_;
  sum_ += index;
}

int Spread::percentile(int percent) const {
  const std::uint64_t rank = std::max<std::uint64_t>(1, (count_ * percent + 99) / 100);
  std::uint64_t seen = 0;
  for (std::size_t value = 0; value < times_.size(); ++value) {
    seen += times_[value];
    if (seen >= rank) return static_cast<int>(value);
  }
  return max();
}

}  // namespace racebeam
