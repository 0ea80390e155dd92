// A unit under random inputs beside a reference that is told the same.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "tb/twin/unit_bench.h"

namespace racebeam {

/// Shakes the inputs for so many clocks. `clock` lets the reference take them; `check` compares,
/// before each edge and after it: a sleeping process that misses an input shows here.
template <class Clock, class Check>
void run_beside(UnitBench& bench, unsigned seed, int clocks, Clock clock, Check check) {
  std::minstd_rand random(seed);
  for (int n = 0; n < clocks; ++n) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", clock " << n);
    bench.shake(random);
    bench.settle();
    ASSERT_NO_FATAL_FAILURE(check()) << "before the edge";
    clock();
    bench.clock();
    ASSERT_NO_FATAL_FAILURE(check()) << "after the edge";
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace racebeam
