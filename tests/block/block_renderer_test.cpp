// Promises of sc/block/block_renderer.h: clock by clock, what scheduler, cores and bus do.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/support/block_scenes.h"

namespace racebeam {
namespace {

using Word = std::tuple<std::int64_t, int, std::uint64_t>;  // clock, address, pixels

block_knobs knobs_of(int cores) {
  block_knobs k;
  k.cores = cores;
  return k;
}

/// A store that is busy in some clocks.
bool takes(std::int64_t clock) { return (clock * 2654435761u >> 7) % 5 != 0; }
bool takes_always(std::int64_t) { return true; }

struct Picture {
  std::vector<Word> words;
  block_counters counters;
};

template <class Takes>
Picture draw(int cores, Takes&& takes_in) {
  block_renderer renderer(knobs_of(cores), converted(quad_tables(), {}));
  Picture picture;
  renderer.draw([&](std::int64_t clock, const block_word& word) {
    if (takes_in(clock)) picture.words.emplace_back(clock, word.address, word.pixels);
    return takes_in(clock);
  });
  picture.counters = renderer.counters();
  return picture;
}

/// The same, each core looked at in each clock.
Picture draw_clock_by_clock(int cores) {
  struct Core {
    bool idle = true;
    int clock = 0;
    std::size_t next = 0;
    block_job job;
  };
  block_rays rays({}, converted(quad_tables(), {}));
  std::vector<Core> all(static_cast<std::size_t>(cores));
  Picture picture;
  int jobs = 0, last = cores - 1;
  for (std::int64_t clock = 0;; ++clock) {
    int served = -1, idle = -1, asking = 0, busy = 0;
    for (int n = 0; n < cores; ++n) {
      const int in_turn = (last + 1 + n) % cores;
      const Core& c = all[static_cast<std::size_t>(in_turn)];
      if (c.idle) continue;
      ++busy;
      if (c.next == c.job.words.size() || c.clock != c.job.words[c.next].clock) continue;
      ++asking;
      if (served < 0) served = in_turn;
    }
    if (jobs == 1200 && !busy) {
      picture.counters.clocks = static_cast<std::uint64_t>(clock);
      return picture;
    }
    for (int n = cores - 1; n >= 0; --n)
      if (all[static_cast<std::size_t>(n)].idle) idle = n;
    const bool taken = served >= 0 && takes(clock);
    picture.counters.bus_stalls += static_cast<unsigned>(asking - taken);
    for (int n = 0; n < cores; ++n) {
      Core& c = all[static_cast<std::size_t>(n)];
      if (c.idle) {
        if (n != idle || jobs == 1200) continue;
        c = {false, 0, 0, rays.job(jobs % 40 * BlockSide, jobs / 40 * BlockSide)};
        ++jobs;
        continue;
      }
      if (c.next < c.job.words.size() && c.clock == c.job.words[c.next].clock) {
        if (n != served || !taken) continue;
        const block_word& word = c.job.words[c.next++];
        picture.words.emplace_back(clock, word.address, word.pixels);
        last = n;
      }
      c.idle = ++c.clock == c.job.clocks;
    }
  }
}

TEST(BlockRenderer, IsTheCoresClockByClock) {
  for (const int cores : {1, 3, 64}) {
    const Picture drawn = draw(cores, takes), wanted = draw_clock_by_clock(cores);
    EXPECT_EQ(drawn.counters.clocks, wanted.counters.clocks) << cores;
    EXPECT_EQ(drawn.counters.bus_stalls, wanted.counters.bus_stalls) << cores;
    EXPECT_TRUE(drawn.words == wanted.words) << cores;
  }
}

TEST(BlockRenderer, OneCoreIsIdleForAClockBeforeEachBlock) {
  const Picture drawn = draw(1, takes_always);
  EXPECT_EQ(drawn.counters.clocks, 3172601u + 1200);
  EXPECT_EQ(drawn.counters.bus_stalls, 0u);
}

TEST(BlockRenderer, AnyNumberOfCoresDrawsTheSameWordsInTheSameBusyClocks) {
  const auto sorted = [](Picture picture) {
    for (Word& word : picture.words) std::get<0>(word) = 0;
    std::sort(picture.words.begin(), picture.words.end());
    return picture.words;
  };
  const auto one = sorted(draw(1, takes_always));
  EXPECT_EQ(one.size(), 640u * 480 / 8 * 3);
  for (const int cores : {3, 16}) {
    const Picture drawn = draw(cores, takes);
    EXPECT_TRUE(sorted(drawn) == one) << cores;
    const auto& busy = drawn.counters.busy_by_core;
    EXPECT_EQ(std::accumulate(busy.begin(), busy.end(), std::uint64_t{0}), 3172601u) << cores;
    EXPECT_EQ(drawn.counters.busy_clocks, 3172601u) << cores;
    EXPECT_GT(busy[static_cast<std::size_t>(cores - 1)], 0u);
  }
}

// The design's machine: a large picture, and as if each core had a bus of its own.
TEST(BlockRenderer, WithoutABusCoresAreAsBusyAsTheDesignSays) {
  block_knobs k;
  k.size = BlockSize1920;
  block_tables tables = forty_tables();
  tables.screen = {10.667f, 6};
  block_rays rays(k, converted(tables, k));
  std::vector<std::int64_t> jobs;
  for (int y = 0; y < k.rows(); y += BlockSide)
    for (int x = 0; x < k.columns(); x += BlockSide) jobs.push_back(rays.job(x, y).clocks);
  const auto busy = static_cast<double>(std::accumulate(jobs.begin(), jobs.end(), std::int64_t{0}));
  EXPECT_NEAR(busy, 79.02e6, 0.005e6);
  for (const auto& [cores, share] : {std::pair{1, 100.0}, {16, 99.9}, {35, 99.7}, {64, 98.9}}) {
    std::priority_queue<std::int64_t, std::vector<std::int64_t>, std::greater<>> idle;
    for (int n = 0; n < cores; ++n) idle.push(n);
    std::int64_t dealt = -1, end = 0;
    for (const std::int64_t clocks : jobs) {
      dealt = std::max(dealt + 1, idle.top());
      idle.pop();
      idle.push(dealt + 1 + clocks);
      end = std::max(end, dealt + 1 + clocks);
    }
    EXPECT_NEAR(100 * busy / static_cast<double>(end * cores), share, 0.05) << cores;
  }
}

TEST(BlockRenderer, TheBusCosts35CoresLessThan4PercentOfForty) {
  block_renderer renderer(knobs_of(35), converted(forty_tables(), {}));
  renderer.draw([](std::int64_t, const block_word&) { return true; });
  const block_counters& n = renderer.counters();
  const double efficiency = static_cast<double>(n.busy_clocks) / static_cast<double>(n.clocks * 35);
  EXPECT_NEAR(efficiency, 0.963, 0.001);
}

// A pixel begins where its core enters PIXEL: between the words, later by what those before waited.
TEST(BlockRenderer, NotesBlocksAndTheBeginOfEachPixel) {
  block_renderer renderer(knobs_of(3), converted(quad_tables(), {}));
  block_renderer::notes notes;
  renderer.note(&notes);
  std::vector<Word> words;
  renderer.draw([&](std::int64_t clock, const block_word& word) {
    if (takes(clock)) words.emplace_back(clock, word.address, word.pixels);
    return takes(clock);
  });
  ASSERT_EQ(notes.blocks.size(), 1200u);
  ASSERT_EQ(notes.begins.size(), 640u * 480);
  block_rays rays({}, converted(quad_tables(), {}));
  std::map<int, std::int64_t> taken;  // clock by address, of the red plane
  for (const Word& word : words) taken[std::get<1>(word)] = std::get<0>(word);
  int looked = 0;
  for (int block = 0; block < 1200; ++block) {
    const int x0 = block % 40 * BlockSide, y0 = block / 40 * BlockSide;
    const block_job job = rays.job(x0, y0);
    if (job.cleared) continue;
    for (int y = y0; y < y0 + BlockSide; ++y)
      for (int x = x0 + 8; x < x0 + BlockSide; x += 8) {
        // After three words the next eight pixels begin in the clock after the blue one.
        const std::int64_t blue = taken.at(2 * 38400 + y * 80 + x / 8 - 1);
        ASSERT_EQ(notes.begins[static_cast<std::size_t>(y * 640 + x)], blue + 1) << x << "," << y;
        ++looked;
      }
  }
  EXPECT_GT(looked, 1000);
}

TEST(BlockRenderer, PicturesFollowEachOther) {
  block_renderer renderer(knobs_of(4), converted(quad_tables(), {}));
  const auto taken = [](std::int64_t, const block_word&) { return true; };
  renderer.draw(taken);
  const block_counters first = renderer.counters();
  renderer.draw(taken);
  EXPECT_EQ(renderer.counters().busy_clocks, first.busy_clocks);
  EXPECT_EQ(renderer.counters().words, first.words);
}

}  // namespace
}  // namespace racebeam
