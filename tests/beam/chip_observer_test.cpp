// What an observer of chip_lines is told: intervals, restarts and pixels of whole frames.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/tlm/chip_observer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "sc/beam/tlm/chip_lines.h"
#include "tb/monitor/vga_monitor.h"

namespace racebeam {
namespace {

/// Puts the picture together from what it is told.
struct Witness : chip_observer {
  std::vector<taken_interval> intervals;
  std::vector<std::uint8_t> colours = std::vector<std::uint8_t>(VisibleColumns * VisibleRows, 255);
  std::vector<std::array<int, 2>> starts;   // line, clock
  std::vector<std::array<int, 4>> entries;  // line, clock, room, depth
  int restarts = 0, columns = 0, overlaps = 0;
  std::uint64_t decisions = 0;

  void started(int y, int clock) override { starts.push_back({y, clock}); }
  void entered(int y, int clock, int room, int depth) override {
    entries.push_back({y, clock, room, depth});
  }
  void interval(const taken_interval& taken) override { intervals.push_back(taken); }
  void restart(int, int, int) override { ++restarts; }
  void line_end(int y, int count) override {
    if (y >= FirstVisibleLine && y < FirstVisibleLine + VisibleRows) decisions += count;
  }
  void shown(int y, int column, int count, int colour) override {
    columns += count;
    for (int i = 0; i < count; ++i) {
      auto& pixel = colours[(y - FirstVisibleLine) * VisibleColumns + column + i];
      overlaps += pixel != 255;
      pixel = static_cast<std::uint8_t>(colour);
    }
  }
};

class ChipObserved : public testing::TestWithParam<int> {
 protected:
  ChipObserved() : chip({{}, nullptr, false, false, &witness}) {
    chip.deposit(GetParam());
    for (int i = 0; i < FrameLines; ++i) {
      chip.run_line();
      if (chip.visible()) picture.insert(picture.end(), chip.pixels().begin(), chip.pixels().end());
    }
    stats = chip.take_stats();
  }
  Witness witness;
  chip_lines chip;
  std::vector<std::uint8_t> picture;
  frame_stats stats;
};

INSTANTIATE_TEST_SUITE_P(Frames, ChipObserved, testing::Values(1000, 2600, 3900, 7223, 8980));

TEST_P(ChipObserved, SeesEveryPixelOnce) {
  EXPECT_EQ(witness.columns, VisibleColumns * VisibleRows);
  EXPECT_EQ(witness.overlaps, 0);
  EXPECT_TRUE(witness.colours == picture);
}

TEST_P(ChipObserved, SeesWhatIsCounted) {
  std::uint64_t emits = 0, give_ups = 0;
  for (const taken_interval& i : witness.intervals) {
    if (i.y < FirstVisibleLine || i.y >= FirstVisibleLine + VisibleRows) continue;
    ++emits;
    give_ups += i.given_up;
  }
  EXPECT_EQ(emits, stats.emits);
  EXPECT_EQ(give_ups, stats.give_ups);
  EXPECT_EQ(witness.decisions, stats.decisions());
  EXPECT_GE(static_cast<std::uint64_t>(witness.restarts), stats.restarts);
}

// Intervals of a line follow each other without a gap, in time order, from pixel 0.
TEST_P(ChipObserved, SeesIntervalsInTheOrderOfPixelsAndClocks) {
  const taken_interval* last = nullptr;
  for (const taken_interval& i : witness.intervals) {
    const bool first = !last || last->y != i.y;
    ASSERT_EQ(i.first, first ? 0 : last->last + 1) << "line " << i.y;
    ASSERT_LE(i.first, i.last);
    if (!first) {
      ASSERT_GT(i.clock, last->clock);
      ASSERT_GE(i.decisions, last->decisions);
    }
    last = &i;
  }
}

// One room deeper, one back, or to the camera's by a restart; intervals end where the tracer is.
// Back from the camera's, where the stack has run empty: depth 15, for the clock before the
// restart.
TEST_P(ChipObserved, SeesTheRoomsOfEachLineFromTheCamerasOn) {
  EXPECT_EQ(witness.starts.size(), static_cast<std::size_t>(FrameLines));
  const std::array<int, 4>* last = nullptr;
  int lines = 0;
  for (const auto& entry : witness.entries) {
    const auto& [y, clock, room, depth] = entry;
    const bool first = !last || (*last)[0] != y;
    lines += first;
    if (first) {
      ASSERT_EQ(depth, 0) << "line " << y;
    } else {
      ASSERT_GT(clock, (*last)[1]);
      const int deeper = (depth - (*last)[3]) & low_bits(DepthBits);
      ASSERT_TRUE(depth == 0 || deeper == 1 || deeper == low_bits(DepthBits)) << "line " << y;
    }
    last = &entry;
  }
  EXPECT_EQ(lines, FrameLines - 1) << "none in the navigator's line";
  auto next = witness.entries.begin();
  for (const taken_interval& i : witness.intervals) {
    if (i.y == LastLine) continue;
    while (next != witness.entries.end() &&
           std::tie((*next)[0], (*next)[1]) <= std::tie(i.y, i.clock))
      ++next;
    ASSERT_EQ((*(next - 1))[0], i.y);
    ASSERT_EQ((*(next - 1))[2], i.room) << "line " << i.y << " clock " << i.clock;
  }
}

// A frame without starvation: every pixel is known before it is shown, one column further right,
// in the colour of its interval. Two frames of one palette without an inverse: values are colours.
TEST(ChipObserver, IntervalsAreWhatIsShownOneColumnFurther) {
  Witness witness;
  chip_lines chip({{}, nullptr, false, false, &witness});
  chip.deposit(1000);
  for (int i = 0; i < FrameLines; ++i) chip.run_line();
  ASSERT_EQ(chip.take_stats().starved_pixels, 0u);
  constexpr int palette[4] = {0, 1, 6, 43};  // contract 15.2
  for (const taken_interval& i : witness.intervals) {
    if (i.y < FirstVisibleLine || i.y >= FirstVisibleLine + VisibleRows) continue;
    for (int pixel = i.first; pixel <= std::min(i.last, LastPixel - 1); ++pixel) {
      ASSERT_LE(i.clock, chip.column_clock(pixel + 1));
      ASSERT_EQ(witness.colours[(i.y - FirstVisibleLine) * VisibleColumns + pixel + 1],
                palette[i.value])
          << "line " << i.y << " pixel " << pixel;
    }
  }
}

// With the pins wanted, lines of a ray pattern are clocked by all units: another way to the same.
class ChipObservedTwice : public testing::TestWithParam<int> {};

TEST_P(ChipObservedTwice, TellsTheSameWhetherThePinsAreWantedOrNot) {
  Witness fast, slow;
  chip_lines a({{}, nullptr, false, false, &fast}), b({{}, nullptr, true, false, &slow});
  for (chip_lines* chip : {&a, &b}) {
    chip->deposit(GetParam());
    for (int i = 0; i < FrameLines; ++i) chip->run_line();
  }
  const auto all = [](const taken_interval& i) {
    return std::tie(i.y, i.clock, i.first, i.last, i.value, i.room, i.depth, i.face, i.behind,
                    i.given_up, i.decisions);
  };
  ASSERT_EQ(fast.intervals.size(), slow.intervals.size());
  for (std::size_t i = 0; i < fast.intervals.size(); ++i)
    ASSERT_TRUE(all(fast.intervals[i]) == all(slow.intervals[i])) << "interval " << i;
  EXPECT_EQ(fast.restarts, slow.restarts);
  EXPECT_TRUE(fast.starts == slow.starts);
  EXPECT_TRUE(fast.entries == slow.entries);
  EXPECT_TRUE(fast.colours == slow.colours);
}

INSTANTIATE_TEST_SUITE_P(Frames, ChipObservedTwice, testing::Values(2450, 3650, 3900, 7223));

TEST(ColourOfPins, IsWhatAMonitorSees) {
  for (int uo = 0; uo < 256; ++uo)
    EXPECT_EQ(pixel_output_core::colour_of_pins(uo), colour_of_pins(uo)) << uo;
}

}  // namespace
}  // namespace racebeam
