// The maps of a frame against the chip's registers, clock by clock.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/frame_maps.h"

#include <gtest/gtest.h>

#include <numeric>
#include <sstream>
#include <vector>

#include "sc/beam/chip_core.h"
#include "sc/beam/stats_collector.h"
#include "tb/bench/interval_watcher.h"
#include "tb/bench/signal_bench.h"
#include "tb/bench/tlm_bench.h"

namespace racebeam {
namespace {

/// A frame of the demo, with a plain bookkeeping of its own beside the watcher.
struct WatchedFrame {
  static constexpr int Late = 1 << 20;  // slack of a pixel that was never known: minus this

  std::vector<IntervalEvent> events;
  frame_stats stats;
  std::vector<int> slack, depth;   // 640 x 480, by column
  std::vector<bool> starved;       // the same, from the FIFO's own flag
  std::vector<int> columns_known;  // of a line, so far: clock
  std::vector<int> columns_deep;

  WatchedFrame(int number, const knobs& k) {
    chip_core chip;
    chip.clock(false, k);
    chip.deposit(number, k);
    stats_collector collector;
    IntervalWatcher watcher;
    int clock = 0;
    std::vector<int> shown;
    for (long left = 2L * LinePixels * FrameLines; left > 0; --left) {
      const int room = chip.decision_datapath.room_q, face = chip.decision_datapath.hit_face_q;
      const int depth_now = chip.decision_datapath.depth_q, length = chip.subdivider.len_m1() + 1;
      chip_view v;
      chip.clock(true, k, &v);
      collector.observe(v);
      watcher.observe(v, room, face);
      const bool visible = v.y >= FirstVisibleLine && v.y < FirstVisibleLine + VisibleRows;
      if (visible && v.consume) {
        shown.push_back(clock);
        starved.push_back(v.starving);
      }
      if (visible && v.emit && v.ack) {
        columns_known.insert(columns_known.end(), length, clock);
        columns_deep.insert(columns_deep.end(), length, depth_now);
      }
      ++clock;
      if (!v.line_end) continue;
      if (visible) end_line(shown);
      clock = 0;
      shown.clear();
      columns_known = {0};  // the FIFO's own pixel
      columns_deep = {0};
    }
    events = watcher.take();
    stats = collector.take();
  }

  void end_line(const std::vector<int>& shown) {
    for (std::size_t column = 0; column < shown.size(); ++column) {
      const bool known = column < columns_known.size();
      slack.push_back(known ? shown[column] - columns_known[column] : -Late);
      depth.push_back(known ? columns_deep[column] : -1);
    }
  }
};

// A frame without a starved pixel, one with many, and one under a partial ray pattern.
class FrameMapsTest : public testing::TestWithParam<int> {
 protected:
  const knobs k;
  const Raster raster;
  const WatchedFrame frame{GetParam(), k};
};

TEST_P(FrameMapsTest, SlackIsTheTimeFromTheAcceptedIntervalToTheSampledPixel) {
  const FrameMap map = make_map(MapKind::Slack, frame.events, raster);
  ASSERT_EQ(frame.slack.size(), map.values.size());
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    if (frame.slack[i] == -WatchedFrame::Late) ASSERT_EQ(map.values[i], FrameMap::Unknown) << i;
    else ASSERT_EQ(map.values[i], frame.slack[i]) << i;
  }
}

TEST_P(FrameMapsTest, PixelsWithoutSlackAreTheStarvedOnes) {
  const FrameMap map = make_map(MapKind::Slack, frame.events, raster);
  std::uint64_t starved = 0;
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    ASSERT_EQ(map.values[i] <= 0, frame.starved[i]) << i;
    starved += map.values[i] <= 0;
  }
  EXPECT_EQ(starved, frame.stats.starved_pixels);
}

TEST_P(FrameMapsTest, CostAddsUpToTheDecisionsOfTheFrame) {
  std::uint64_t decisions = 0;
  double off_screen = 0;
  for (const IntervalEvent& event : frame.events) {
    decisions += event.decisions;
    if (event.to == LastPixel) off_screen += static_cast<double>(event.decisions) / event.length();
  }
  EXPECT_EQ(decisions, frame.stats.decisions());
  const FrameMap map = make_map(MapKind::Cost, frame.events, raster);
  const double shown = std::accumulate(map.values.begin(), map.values.end(), 0.0);
  EXPECT_NEAR(shown + off_screen, static_cast<double>(decisions), 1e-6 * decisions);
}

TEST_P(FrameMapsTest, DepthIsTheTracersWhenThePixelWasAccepted) {
  const FrameMap map = make_map(MapKind::Depth, frame.events, raster);
  for (std::size_t i = 0; i < map.values.size(); ++i) {
    if (frame.depth[i] < 0) ASSERT_EQ(map.values[i], FrameMap::Unknown) << i;
    else ASSERT_EQ(map.values[i], frame.depth[i]) << i;
  }
}

TEST_P(FrameMapsTest, EventsCoverEveryPixelOfEveryLineOnce) {
  int y = FirstVisibleLine, next = 0;
  for (const IntervalEvent& event : frame.events) {
    ASSERT_EQ(event.y, y);
    ASSERT_EQ(event.from, next);
    ASSERT_LE(event.from, event.to);
    next = event.to + 1;
    if (next <= LastPixel) continue;
    ++y;
    next = 0;
  }
  EXPECT_EQ(y, FirstVisibleLine + VisibleRows);
}

TEST_P(FrameMapsTest, OnlyGivenUpIntervalsHaveNoWall) {
  std::uint64_t given_up = 0;
  for (const IntervalEvent& event : frame.events) given_up += event.known() && !event.wall;
  EXPECT_EQ(given_up, frame.stats.give_ups);
}

std::string text(const IntervalEvent& e) {
  std::ostringstream out;
  out << e.y << ' ' << e.from << ".." << e.to << " clock " << e.clock << " cost " << e.decisions
      << " depth " << e.depth << " room " << e.room << " face " << e.face << " behind " << e.behind
      << " wall " << e.wall;
  return out.str();
}

void expect_intervals_of_the_cores(ChipBench& bench, const std::vector<int>& frames) {
  for (const int number : frames) {
    bench.seek(number);
    const auto got = bench.render().intervals;
    const auto core = WatchedFrame(number, {}).events;
    ASSERT_EQ(got.size(), core.size());
    for (std::size_t i = 0; i < core.size(); ++i) ASSERT_EQ(text(got[i]), text(core[i]));
  }
}

TEST(FrameMaps, SignalLevelTellsOfTheSameIntervalsAsTheCores) {
  SignalBench::Options options;
  options.intervals = true;
  SignalBench bench(options);
  expect_intervals_of_the_cores(bench, {7223, 60});
}

TEST(FrameMaps, TlmLevelTellsOfTheSameIntervalsAsTheCores) {
  TlmBench::Options options;
  options.intervals = true;
  TlmBench bench(options);
  expect_intervals_of_the_cores(bench, {7223, 60, 2432, 3900, 8980, 12500});
}

INSTANTIATE_TEST_SUITE_P(Demo, FrameMapsTest, testing::Values(1000, 2432, 7223));

}  // namespace
}  // namespace racebeam
