// Random traffic comes where a designer's mistakes hide: the FIFO full and starving again and
// again, inputs of one bit at rest and in bursts, values that meet; and it keeps to what a chip can
// have.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/random_traffic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "sc/base/engine.h"
#include "tb/twin/twins.h"

namespace racebeam {
namespace {

class RandomTrafficTest : public testing::Test {
 protected:
  /// The unit of the chip in so many clocks; `each` sees the pins of each.
  void run(const std::string& unit, int clocks, unsigned seed,
           const std::function<void(UnitBench&)>& each) const {
    const Twins& row = twins().front();
    const knob_values k = row.engine.standard(nullptr);
    const auto model = row.engine.unit(unit)->make("model", k, nullptr);
    UnitBench bench(*model);
    RandomTraffic traffic(bench, row.inputs(k), seed);
    for (int clock = 0; clock < clocks; ++clock) {
      if (clock > 0) traffic.next();
      bench.settle();
      each(bench);
      bench.clock();
    }
  }
};

TEST_F(RandomTrafficTest, TheFifoIsFullAndEmptyAgainManyTimes) {
  constexpr std::uint64_t Full = 10, Empty = 1;
  int fills = 0, drains = 0;
  bool was_full = false;
  run("interval_fifo", 20'000, 1, [&](UnitBench& bench) {
    const std::uint64_t fill = bench["fill_o"].value();
    if (!was_full && fill == Full) ++fills, was_full = true;
    if (was_full && fill == Empty) ++drains, was_full = false;
  });
  EXPECT_GT(fills, 10);
  EXPECT_GT(drains, 10);
}

TEST_F(RandomTrafficTest, ABitIsHeldAndPulsesAndIsNoisy) {
  int longest = 0, pulses = 0, length = 0;
  std::uint64_t was = 0;
  run("interval_fifo", 20'000, 2, [&](UnitBench& bench) {
    const std::uint64_t now = bench["consume_i"].value();
    if (now != was) {
      if (length == 1) ++pulses;
      length = 0;
    }
    longest = std::max(longest, ++length);
    was = now;
  });
  EXPECT_GT(longest, 500);
  EXPECT_GT(pulses, 500);
}

TEST_F(RandomTrafficTest, OnlyLegalValuesAreDriven) {
  std::set<std::uint64_t> sizes;
  run("ray_stepper", 20'000, 4,
      [&](UnitBench& bench) { sizes.insert(bench["step_size_i"].value()); });
  for (const std::uint64_t size : sizes) EXPECT_EQ(size & (size - 1), 0u) << "no power of two";
  EXPECT_GE(sizes.size(), 10u) << "all powers of two";
}

TEST_F(RandomTrafficTest, TheFirstClockIsInReset) {
  int clock = 0;
  run("interval_fifo", 1, 5, [&](UnitBench& bench) {
    ++clock;
    EXPECT_EQ(bench["tracer_reset_i"].value(), 1u);
  });
  EXPECT_EQ(clock, 1);
}

}  // namespace
}  // namespace racebeam
