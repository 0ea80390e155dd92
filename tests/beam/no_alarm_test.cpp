// No false alarm in the demo: progress comes to the right chip in far less time than hang_watch
// waits for it. It is told from the cores, clock by clock; the wired chip sees the same.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

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

/// Rising edges of one of two wires, and the longest time between clocks that have one.
struct Edges {
  std::uint64_t count = 0, since = 0, longest = 0;
  void see(bool one, bool other) {
    const bool rises = (one && !one_) || (other && !other_);
    one_ = one;
    other_ = other;
    count += rises;
    time(rises);
  }
  void time(bool rises) {
    since = rises ? 0 : since + 1;
    longest = std::max(longest, since);
  }

 private:
  bool one_ = false, other_ = false;  // in the last clock
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

/// Edges of the wired chip, in which wires may rise several times until they settle.
struct WiredEdges {
  Edges settled, kernel;      ///< as the cores have them, and as HangWatch hears them
  std::uint64_t in_vain = 0;  ///< clocks in which a wire rose, and neither is 1 in the end
  bool rose = false;          ///< in this clock
  void hear(std::initializer_list<const wire<1>*> wires) {
    sc_core::sc_spawn_options process;
    process.spawn_method();
    process.dont_initialize();
    for (const wire<1>* one : wires) process.set_sensitivity(&one->posedge_event());
    sc_core::sc_spawn([this] { rose = true; }, sc_core::sc_gen_unique_name("rise"), &process);
  }
  void clock(bool one, bool other) {
    const std::uint64_t before = settled.count;
    settled.see(one, other);
    EXPECT_TRUE(rose || settled.count == before) << "it rose, and nobody heard of it";
    in_vain += rose && !one && !other;
    kernel.time(std::exchange(rose, false));
  }
};

void expect_same(const WiredEdges& wired, const Edges& cores) {
  EXPECT_EQ(wired.settled.count, cores.count);
  EXPECT_EQ(wired.settled.longest, cores.longest);
  EXPECT_EQ(wired.kernel.longest, cores.longest);
}
void expect_same_in(int frame) {
  WiredEdges progress, rare;
  bool begun = false;
  WiredBench::Watches watches;
  watches.each_edge = [&](const wired_chip& watched) {
    const auto& wires = static_cast<const chip&>(watched);
    if (!begun) return;
    progress.clock(wires.ack.read(), wires.lock.read());
    rare.clock(wires.line_done.read(), wires.lock.read());
  };
  WiredBench bench({beam_engine(), knobs(), nullptr, DemoFrames}, watches);
  bench.seek(frame);
  begun = true;
  const auto& wires = static_cast<const chip&>(bench.dut());
  progress.hear({&wires.ack, &wires.lock});
  rare.hear({&wires.line_done, &wires.lock});
  bench.advance(raster.frame_clocks());
  const Progress cores = of_cores(frame, 1);
  EXPECT_GT(cores.progress.count, 400u);
  expect_same(progress, cores.progress);
  expect_same(rare, cores.rare);
  std::cout << "frame " << frame << ": " << cores.progress.count << " edges, "
            << cores.progress.longest << " clocks without at most; the kernel has "
            << progress.in_vain << " edges more, of wires that then are 0\n";
}

class WiredProgress : public testing::TestWithParam<int> {};
TEST_P(WiredProgress, IsThatOfTheCores) { expect_same_in(GetParam()); }
using LongWiredProgress = WiredProgress;
TEST_P(LongWiredProgress, IsThatOfTheCores) { expect_same_in(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Frames, WiredProgress, testing::Values(7140));
INSTANTIATE_TEST_SUITE_P(LongFrames, LongWiredProgress,
                         testing::Values(0, 2600, 4000, 4860, 5000, 7223, 9800, 12500));

// HangWatch does not even begin to look at the waits.
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
