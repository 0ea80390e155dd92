// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/pin_stats.h"

#include <gtest/gtest.h>

namespace racebeam {
namespace {

constexpr int Uio7 = 15;

TEST(PinStats, CountsChangesAndClocksAtOne) {
  PinCounter counter;
  counter.change({100, 0x01, 0x80, 0x80});
  counter.change({103, 0x03, 0x80, 0x80});
  counter.change({107, 0x02, 0x00, 0x80});
  const PinStats stats = counter.take(110);
  EXPECT_EQ(stats.clocks, 10u);
  EXPECT_EQ(stats.toggles[0], 1u) << "the first value is no change";
  EXPECT_EQ(stats.high[0], 7u);
  EXPECT_EQ(stats.toggles[1], 1u);
  EXPECT_EQ(stats.high[1], 7u);
  EXPECT_EQ(stats.toggles[Uio7], 1u);
  EXPECT_EQ(stats.high[Uio7], 7u);
  EXPECT_EQ(stats.enabled[Uio7], 10u);
  EXPECT_EQ(stats.enabled[8], 0u);
  EXPECT_EQ(stats.enabled[0], 10u) << "uo_out is always driven";
}

TEST(PinStats, FramesJoinWithoutAGap) {
  PinCounter counter;
  counter.change({0, 0x01, 0, 0});
  PinStats total = counter.take(5);
  counter.change({5, 0x00, 0, 0});
  counter.change({6, 0x01, 0, 0});
  const PinStats second = counter.take(10);
  EXPECT_EQ(second.toggles[0], 2u) << "a change in the first clock belongs to this frame";
  EXPECT_EQ(second.high[0], 4u);
  total += second;
  EXPECT_EQ(total.clocks, 10u);
  EXPECT_EQ(total.high[0], 9u);
  EXPECT_EQ(total.toggles[0], 2u);
}

}  // namespace
}  // namespace racebeam
