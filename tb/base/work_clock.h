// A clock that a busy machine does not turn faster: limits of proofs are read from it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace racebeam {

/// What processors have worked for this process, and for others that it has waited for.
struct WorkClock {
  using duration = std::chrono::microseconds;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<WorkClock>;
  static constexpr bool is_steady = true;

  static time_point now();
};

}  // namespace racebeam
