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

/// Episodes to begin with, made of a stream without clocks.
using Known = std::function<std::vector<PortStream>(const PortStream& form)>;

class RandomTrafficTest : public testing::Test {
 protected:
  /// The unit of the chip in so many clocks; `each` sees the pins of each.
  void run(const std::string& unit, int clocks, unsigned seed,
           const std::function<void(UnitBench&)>& each, const Known& known = {}) const {
    const Twins& row = twins().front();
    const knob_values k = row.engine.standard(nullptr);
    const auto model = row.engine.unit(unit)->make("model", k, nullptr);
    UnitBench bench(*model);
    RandomTraffic traffic(bench, row.inputs(k, nullptr, unit), seed);
    if (known)
      traffic.begin_with(known(stream_of(traffic_of(unit, bench), row.inputs(k, nullptr, unit))));
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

TEST_F(RandomTrafficTest, KnownEpisodesComeFirstAndThenNowAndAgain) {
  using Row = std::vector<std::uint64_t>;
  std::vector<Row> expected, rows;
  const auto episodes = [&](const PortStream& form) {
    std::vector<PortStream> known;
    for (const std::uint64_t clocks : {5, 9}) {
      known.push_back(form);
      for (std::uint64_t n = 0; n < clocks * form.inputs.size(); ++n)
        known.back().values.push_back((n / 3 + clocks) % 2);
      known.back().begin_in_reset();
      const auto& values = known.back().values;
      const auto wide = static_cast<std::ptrdiff_t>(form.inputs.size());
      for (auto at = values.begin(); at != values.end(); at += wide)
        expected.emplace_back(at, at + wide);
    }
    return known;
  };
  const auto each = [&](UnitBench& bench) {
    Row row;
    for (const UnitBench::Pin* pin : bench.pins())
      if (pin->input) row.push_back(pin->value());
    rows.push_back(row);
  };
  run("interval_fifo", 20'000, 5, each, episodes);
  ASSERT_EQ(expected.size(), 14u);
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), rows.begin() + 1));
  int again = 0;  // the longer one
  for (auto at = rows.begin() + 15; at != rows.end(); ++again)
    if ((at = std::search(at, rows.end(), expected.begin() + 5, expected.end())) != rows.end())
      ++at;
  EXPECT_GT(again, 3);
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
