// No false alarm in the demo: progress comes to the right chip in far less time than hang_watch
// waits for it. It is told from the cores, clock by clock; the wired chip sees the same.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "sc/beam/chip.h"
#include "sc/beam/chip_core.h"
#include "sc/beam/engine.h"
#include "tb/bench/waits.h"
#include "tb/bench/wired_bench.h"
#include "tb/monitor/raster.h"

namespace racebeam {
namespace {

constexpr int DemoFrames = 12799;
const Raster raster{2, 0};

/// Rising edges of one of several wires, a clock each, and the longest time between two.
struct Edges {
  bool first = false, second = false;  // of the last clock
  std::uint64_t count = 0, since = 0, longest = 0;
  void see(bool one, bool other) { note((one && !first) || (other && !second), one, other); }
  void note(bool rises, bool one, bool other) {
    since = rises ? 0 : since + 1;
    count += rises;
    longest = std::max(longest, since);
    first = one;
    second = other;
  }
};

/// What HangWatch notes of the interval tracer.
struct Progress {
  Edges progress, rare;
  void see(bool ack, bool line_done, bool lock) {
    progress.see(ack, lock);
    rare.see(line_done, lock);
  }
};

Progress of_cores(int first, int frames) {
  const knobs k;
  chip_core core;
  core.clock_video(false, k);
  core.deposit(first, k);
  Progress seen;
  chip_view now{};
  const std::int64_t clocks = std::int64_t{frames} * raster.frame_clocks();
  for (std::int64_t clock = 0; clock < clocks; ++clock) {
    core.clock_video(true, k, &now);
    seen.see(now.ack, now.line_done, now.lock);
  }
  return seen;
}

// A rising edge between two clocks, which the kernel has while the wires settle, counts there.
Progress of_wired_chip(int first, int frames) {
  Progress seen;
  bool rose = false, rare_rose = false;
  WiredBench::Watches watches;
  watches.each_edge = [&](const wired_chip& watched) {
    const auto& wires = static_cast<const chip&>(watched);
    const bool lock = wires.lock.read();
    seen.progress.note(std::exchange(rose, false), wires.ack.read(), lock);
    seen.rare.note(std::exchange(rare_rose, false), wires.line_done.read(), lock);
  };
  WiredBench bench({beam_engine(), knobs(), nullptr, DemoFrames}, watches);
  const auto& wires = static_cast<const chip&>(bench.dut());
  const auto watch = [](std::initializer_list<const wire<1>*> all, bool& flag) {
    sc_core::sc_spawn_options process;
    process.spawn_method();
    process.dont_initialize();
    for (const wire<1>* one : all) process.set_sensitivity(&one->posedge_event());
    sc_core::sc_spawn([&flag] { flag = true; }, sc_core::sc_gen_unique_name("rise"), &process);
  };
  bench.seek(first);
  watch({&wires.ack, &wires.lock}, rose);
  watch({&wires.line_done, &wires.lock}, rare_rose);
  for (int n = 0; n < frames; ++n) bench.advance(raster.frame_clocks());
  return seen;
}

void expect_same(const Edges& got, const Edges& want, int frame) {
  EXPECT_EQ(got.count, want.count) << "frame " << frame;
  EXPECT_EQ(got.longest, want.longest) << "frame " << frame;
}
void expect_same_in(int frame) {
  const Progress cores = of_cores(frame, 1), wired = of_wired_chip(frame, 1);
  EXPECT_GT(cores.progress.count, 400u);
  expect_same(wired.progress, cores.progress, frame);
  expect_same(wired.rare, cores.rare, frame);
}

class WiredProgress : public testing::TestWithParam<int> {};
TEST_P(WiredProgress, IsThatOfTheCores) { expect_same_in(GetParam()); }
using LongWiredProgress = WiredProgress;
TEST_P(LongWiredProgress, IsThatOfTheCores) { expect_same_in(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Frames, WiredProgress, testing::Values(7140));
INSTANTIATE_TEST_SUITE_P(LongFrames, LongWiredProgress,
                         testing::Values(0, 2600, 4000, 4860, 5000, 7223, 9800, 12500));

// A tenth of what HangWatch allows: then it never even looks at the waits.
void expect_no_alarm(int first, int frames) {
  const WaitKind& kind = waits_of(beam_engine());
  const Progress seen = of_cores(first, frames);
  const auto line = static_cast<std::uint64_t>(raster.line_clocks());
  const auto allowed = static_cast<std::uint64_t>(kind.lines) * line;
  const auto rare_allowed = static_cast<std::uint64_t>(kind.rare_lines) * line;
  EXPECT_LT(seen.progress.longest, allowed);
  EXPECT_LT(seen.rare.longest, rare_allowed);
  std::cout << "longest time without: " << seen.progress.longest << " of " << allowed
            << " clocks; a line done: " << seen.rare.longest << " of " << rare_allowed << '\n';
}

TEST(NoAlarm, InTheFramesThatStarveMost) { expect_no_alarm(7138, 4); }
// Minutes each.
TEST(LongNoAlarm, InEveryFrameOfTheFirstHalf) { expect_no_alarm(0, 6400); }
TEST(LongNoAlarm, InEveryFrameOfTheSecondHalf) { expect_no_alarm(6400, 6399); }

}  // namespace
}  // namespace racebeam
