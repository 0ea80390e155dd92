// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/interval_text.h"

#include <gtest/gtest.h>

#include <limits>

namespace racebeam {
namespace {

std::string sampled(double value, double half_width, const std::string& unit = "") {
  return text_of(Estimate{value, half_width, 256, 11'135}, unit);
}

TEST(IntervalTextTest, HasTheDigitsThatTheIntervalSupports) {
  EXPECT_EQ(sampled(3.14159, 0.2468), "3.14 +/- 0.25");
  EXPECT_EQ(sampled(3.14159, 0.2468, "%"), "3.14 % +/- 0.25");
  EXPECT_EQ(sampled(-0.15204, 0.02811), "-0.152 +/- 0.028");
  EXPECT_EQ(sampled(136'204.5, 1'234, "a line"), "136,200 a line +/- 1,200");
  EXPECT_EQ(sampled(1'534.2, 12.3), "1,534 +/- 12");
  EXPECT_EQ(sampled(1'534.2, 123), "1,530 +/- 120");
  EXPECT_EQ(sampled(0.00012345, 0.0000067), "0.0001234 +/- 0.0000067");
  EXPECT_EQ(sampled(12'345'678, 2), "12,345,678.0 +/- 2.0");
}

TEST(IntervalTextTest, RoundingUpDoesNotAddADigit) {
  EXPECT_EQ(sampled(3.14159, 0.0996), "3.14 +/- 0.10");
  EXPECT_EQ(sampled(3.14159, 9.96), "3 +/- 10");
  EXPECT_EQ(sampled(3.14159, 0.994), "3.14 +/- 0.99");
  EXPECT_EQ(sampled(512, 996), "500 +/- 1,000");
}

TEST(IntervalTextTest, ZeroHasNoSign) { EXPECT_EQ(sampled(-0.0004, 0.12), "0.00 +/- 0.12"); }

TEST(IntervalTextTest, SaysWhyThereIsNoInterval) {
  EXPECT_EQ(text_of(Estimate{3.146789, 0, 11'135, 11'135}, "%"), "3.147 % (all 11,135 frames)");
  EXPECT_EQ(text_of(Estimate{4, 0, 1, 1}), "4 (all 1 frame)");
  EXPECT_EQ(sampled(0, 0, "%"), "0 % (alike in 256 frames)");
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sampled(3.14159, infinity, "%"), "3.1 % (too few frames)");
  EXPECT_EQ(sampled(std::numeric_limits<double>::quiet_NaN(), infinity), "not measured");
}

TEST(IntervalTextTest, ExactFiguresHaveAllOrFourDigits) {
  EXPECT_EQ(text_of(6'867, "cells"), "6,867 cells");
  EXPECT_EQ(text_of(0.0), "0");
  EXPECT_EQ(text_of(0.427349), "0.4273");
  EXPECT_EQ(text_of(283.96), "284.0");
  EXPECT_EQ(text_of(-12'345.678), "-12,346");
  EXPECT_EQ(grouped(11'135), "11,135");
  EXPECT_EQ(grouped(999), "999");
}

TEST(IntervalTextTest, AWorstCaseSaysOfHowMany) {
  Worst worst;
  worst.value = 1534;
  worst.frames = 320;
  worst.population = 11'135;
  EXPECT_EQ(text_of(worst, "clocks"), "1,534 clocks (worst of 320 frames)");
  worst.frames = 11'135;
  EXPECT_EQ(text_of(worst, "clocks"), "1,534 clocks (worst of all 11,135 frames)");
  worst.value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(text_of(worst, "clocks"), "not measured");
}

TEST(IntervalTextTest, SharesAreBoundsOrIntervals) {
  EXPECT_EQ(text_of(share_of(0, 256, 11'135)), "fewer than 1.4 % of frames (95 %)");
  EXPECT_EQ(text_of(share_of(256, 256, 11'135)), "more than 98.6 % of frames (95 %)");
  EXPECT_EQ(text_of(share_of(95, 256, 11'135)), "37 % of frames, 31 to 43 % (95 %)");
  EXPECT_EQ(text_of(share_of(0, 256, 11'135, 0.995), 0.995), "fewer than 2.3 % of frames (99.5 %)");
  EXPECT_EQ(text_of(share_of(4'143, 11'135, 11'135)), "37.21 % of all 11,135 frames");
  EXPECT_EQ(text_of(share_of(0, 11'135, 11'135)), "none of 11,135 frames");
}

}  // namespace
}  // namespace racebeam
