// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/chip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "tb/bench/core_bench.h"
#include "tb/bench/signal_bench.h"
#include "tb/bench/tlm_bench.h"
#include "tests/support/expect_stats.h"

namespace racebeam {
namespace {

double mean(const std::vector<int>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Contract 19.1: single frames of part 0, exactly.
struct MeasuredFrame {
  int frame, camera_min;
  double camera_mean;
  int camera_max;
  std::uint64_t left, right, bisect, adjust, descends, pushes, emits, give_ups, restarts, stall,
      starved;
  int done_min, done_mean, done_max;
};
constexpr MeasuredFrame measured_frames[] = {
    {1, 47, 51.1, 53, 39600, 37872, 28258, 4094, 39585, 4182, 4582, 33, 164, 104643, 65, 77, 536,
     1086},
    {2, 47, 51.1, 53, 39090, 37467, 28031, 4092, 39073, 4142, 4551, 49, 159, 110443, 173, 77, 545,
     1076},
    {3, 47, 51.1, 53, 37936, 36555, 27484, 4048, 37910, 4028, 4482, 63, 143, 116691, 335, 77, 552,
     1091},
    {10, 52, 56.1, 58, 35555, 34137, 25591, 4011, 35544, 3801, 4270, 56, 46, 124260, 363, 83, 556,
     1091},
    {60, 55, 59.1, 61, 37800, 36441, 26179, 4744, 37792, 3971, 4385, 41, 45, 110004, 29, 87, 544,
     1047},
    {200, 67, 70.1, 72, 29887, 28357, 26394, 5370, 29874, 4134, 4501, 21, 93, 49588, 8, 98, 394,
     966},
    {400, 69, 72.1, 74, 48447, 46905, 42334, 7830, 48442, 6897, 7256, 7, 190, 75665, 0, 120, 587,
     1217},
    {700, 68, 71.1, 73, 49544, 48986, 45003, 8467, 49544, 6877, 7200, 0, 192, 78493, 0, 98, 605,
     999},
    {1000, 60, 64.1, 66, 43471, 42827, 46664, 8299, 43471, 7076, 7415, 0, 225, 131011, 0, 93, 682,
     1131},
    {1400, 62, 66.1, 68, 70484, 69291, 55561, 9535, 70481, 8714, 9131, 3, 241, 97783, 0, 176, 771,
     1352},
    {1900, 65, 69.1, 71, 55859, 54448, 48861, 8977, 55850, 7646, 7973, 26, 278, 105351, 26, 274,
     700, 1233},
    {2047, 51, 55.1, 57, 46298, 45760, 46558, 8919, 46298, 6789, 6967, 0, 183, 77827, 0, 170, 575,
     1197},
};

TEST(Chip, CountsWhatTheSiliconCountsInPartZero) {
  for (const auto& m : measured_frames) {
    SCOPED_TRACE("frame " + std::to_string(m.frame));
    const frame_stats s = CoreBench({}, m.frame).render().stats;
    const auto [camera_min, camera_max] =
        std::minmax_element(s.camera_clocks.begin(), s.camera_clocks.end());
    EXPECT_EQ(*camera_min, m.camera_min);
    EXPECT_EQ(*camera_max, m.camera_max);
    EXPECT_NEAR(mean(s.camera_clocks), m.camera_mean, 0.05);
    EXPECT_EQ(s.left_decisions, m.left);
    EXPECT_EQ(s.right_decisions, m.right);
    EXPECT_EQ(s.bisection_steps, m.bisect);
    EXPECT_EQ(s.adjust_steps, m.adjust);
    EXPECT_EQ(s.descents, m.descends);
    EXPECT_EQ(s.pushes, m.pushes);
    EXPECT_EQ(s.emits, m.emits);
    EXPECT_EQ(s.give_ups, m.give_ups);
    EXPECT_EQ(s.restarts, m.restarts);
    EXPECT_EQ(s.fifo_full_stalls, m.stall);
    EXPECT_EQ(s.starved_pixels, m.starved);
    const auto [done_min, done_max] = std::minmax_element(s.done_clock.begin(), s.done_clock.end());
    EXPECT_EQ(*done_min, m.done_min);
    EXPECT_EQ(*done_max, m.done_max);
    EXPECT_NEAR(mean(s.done_clock), m.done_mean, 0.5);
  }
}

// Contract 19.2: the frames that starve most in each segment.
TEST(Chip, StarvesAsTheSiliconDoesInEveryPart) {
  const std::pair<int, std::uint64_t> worst[] = {
      {806, 873},     {2048, 2616},   {2342, 536},    {2526, 261351}, {2560, 306720},
      {3204, 263268}, {3406, 261990}, {3584, 306720}, {4090, 255869}, {5555, 5437},
      {7223, 22401},  {8215, 480},    {8833, 6665},   {8980, 25101},  {9392, 21},
      {9482, 4060},   {9974, 1060},   {10071, 374},   {10771, 3786},  {12634, 1050}};
  for (const auto& [frame, starved] : worst)
    EXPECT_EQ(CoreBench({}, frame).render().stats.starved_pixels, starved) << "frame " << frame;
}

// The pictures of both, clock by clock.
void expect_the_cores(const std::vector<int>& frames) {
  SignalBench bench({{}, true, true, false});
  for (const int frame : frames) {
    SCOPED_TRACE("frame " + std::to_string(frame));
    bench.seek(frame);
    const auto got = bench.render();
    const auto expected = CoreBench({}, frame).render();
    EXPECT_EQ(got.picture.pins_crc, expected.pins_crc);
    expect_equal(*got.stats, expected.stats);
  }
}

TEST(Chip, WiresGiveThePinsAndCountersOfTheCoresInEverySceneAndWithEveryEffect) {
  expect_the_cores({1, 2200, 2330, 2600, 3900, 7223, 8400, 8500, 9400, 9700, 12798});
}

// One frame of each row of contract 17.7.
TEST(LongChip, WiresGiveThePinsAndCountersOfTheCoresInEveryPart) {
  expect_the_cores({1,    2,    60,   700,  2100,  2200,  2304,  2330,  2500, 2600, 2700,
                    2850, 3000, 3100, 3250, 3350,  3500,  3600,  3750,  3900, 4000, 5000,
                    7223, 8200, 8400, 8500, 8600,  8754,  8900,  9000,  9100, 9300, 9400,
                    9500, 9700, 9800, 9900, 10000, 10200, 11000, 12500, 12798});
}

TEST(Chip, StartingAtAFrameGivesThePicturesOfRunningFromReset) {
  CoreBench from_reset({});
  for (int frame = 0; frame <= 10; ++frame) {
    if (frame == 1 || frame == 10)
      EXPECT_EQ(from_reset.render().pins_crc, CoreBench({}, frame).render().pins_crc) << frame;
    else from_reset.skip();
  }
}

// The tlm level runs on from reset in a hundredth of the time.
TEST(Chip, StartingAtAFrameGivesThePicturesOfATlmRunFromReset) {
  TlmBench from_reset(TlmBench::Options{});
  for (int frame = 0; frame <= 200; ++frame) {
    const auto picture = from_reset.render().picture;
    if (frame != 60 && frame != 200) continue;
    EXPECT_TRUE(picture.colours == CoreBench({}, frame).render().colours) << frame;
  }
}

TEST(Chip, StartingAfterAFlightRestartGivesThePicturesOfFlyingThroughIt) {
  CoreBench flying({}, 2302);  // restarts at 2304
  for (int frame = 2302; frame <= 2306; ++frame)
    EXPECT_EQ(flying.render().pins_crc, CoreBench({}, frame).render().pins_crc) << frame;
}

TEST(Chip, PicturesFromSeekingEqualPicturesInARow) {
  SignalBench bench({{}, false, true, false});
  bench.seek(8447);  // restart and change of scene at 8448
  const auto a = bench.render(), b = bench.render();
  EXPECT_EQ(b.number, 8448);
  bench.seek(8447);
  EXPECT_EQ(bench.render().picture.pins_crc, a.picture.pins_crc);
  bench.seek(8448);
  EXPECT_EQ(bench.render().picture.pins_crc, b.picture.pins_crc);
}

TEST(Chip, TheDemoRestartsAfterFrame12798) {
  SignalBench bench({{}, false, true, false});
  bench.seek(12798);
  bench.render();
  const auto first = bench.render();
  EXPECT_EQ(first.number, 0);
  EXPECT_EQ(first.picture.pins_crc, CoreBench({}, 0).render().pins_crc);
}

TEST(Chip, ColumnZeroIsIndexZeroInEveryTracedLine) {
  SignalBench bench({{}, false, false, false});
  bench.seek(700);
  const auto picture = bench.render().picture;
  for (int row = 0; row < VisibleRows; ++row)
    EXPECT_EQ(picture.colours[row * VisibleColumns], 0) << "row " << row;  // palette 0: black
}

}  // namespace
}  // namespace racebeam
