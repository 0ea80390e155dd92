// Promises of sc/block/block_machine.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_machine.h"

#include <gtest/gtest.h>

#include <numeric>

#include "sc/store/frame_scanout.h"
#include "tests/support/block_scenes.h"

namespace racebeam {
namespace {

std::uint64_t sum(const std::array<std::uint64_t, MaxWriteBuffer + 1>& fill) {
  return std::accumulate(fill.begin(), fill.end(), std::uint64_t{0});
}

/// FNV-1a over r, g, b, row by row.
std::uint32_t checksum(const block_machine& machine, const block_knobs& k) {
  const std::vector<std::uint64_t> words = machine.picture();
  std::uint32_t sum = 2166136261u;
  for (int n = 0; n < k.columns() * k.rows(); ++n) {
    const auto dac = frame_scanout_core::pixel(words, n / k.columns(), n % k.columns(), k.store());
    for (const int each : {dac.red, dac.green, dac.blue})
      sum = (sum ^ static_cast<unsigned>(each >> 2)) * 16777619u;
  }
  return sum;
}

struct Drawn {
  block_counters counters;
  std::uint32_t checksum;
};

Drawn draw(const block_knobs& k, const block_tables& tables) {
  block_machine machine(k);
  machine.draw(tables);
  return {machine.counters(), checksum(machine, k)};
}

block_knobs with_cores(int cores) {
  block_knobs k;
  k.cores = cores;
  return k;
}

// The clocks of all units in RTL: block_top_test.
TEST(BlockMachine, DrawsQuadInTheClocksOfTheChip) {
  for (const auto& [cores, clocks] : {std::pair{1, 3173801u}, {4, 830854u}, {16, 251684u}}) {
    const Drawn drawn = draw(with_cores(cores), quad_tables());
    EXPECT_EQ(drawn.counters.clocks, clocks) << cores;
    EXPECT_EQ(drawn.checksum, 0xe7be7668u) << cores;
    EXPECT_EQ(drawn.counters.busy_clocks, 3172601u) << cores;
    EXPECT_EQ(drawn.counters.words, 115200u) << cores;
    EXPECT_EQ(drawn.counters.host_clocks, 48u);
    EXPECT_EQ(sum(drawn.counters.buffer_fill), clocks);
    EXPECT_EQ(drawn.counters.buffer_lost, 0u);
  }
}

TEST(BlockMachine, TheBeamReadsThreeWordsInSixteenClocks) {
  const block_counters n = draw(with_cores(1), quad_tables()).counters;
  // Of three whole frames, and of what the picture has of the fourth.
  EXPECT_EQ(n.frames, 3u);
  const std::uint64_t frame = 480 * 80 * 3;
  EXPECT_GT(n.store_reads, 3 * frame);
  EXPECT_LT(n.store_reads, 4 * frame);
}

TEST(BlockMachine, AWordThatFindsTheBufferFullIsLostIfNobodyLooks) {
  block_knobs k = with_cores(16);
  k.write_policy = WritePolicySync;
  const Drawn waits = draw(k, quad_tables());
  EXPECT_GT(waits.counters.buffer_stalls, 0u);
  EXPECT_EQ(waits.checksum, 0xe7be7668u);
  k.when_full = WhenFullDrop;
  const Drawn drops = draw(k, quad_tables());
  EXPECT_EQ(drops.counters.buffer_stalls, 0u);
  EXPECT_GT(drops.counters.buffer_lost, 0u);
  EXPECT_NE(drops.checksum, 0xe7be7668u);
  EXPECT_LT(drops.counters.clocks, waits.counters.clocks);
}

TEST(BlockMachine, PicturesOfAnySizeHaveAllTheirRows) {
  block_knobs k = with_cores(8);
  k.size = BlockSize1920;
  k.background = 0x102030;
  block_machine machine(k);
  machine.draw({});
  const std::vector<std::uint64_t> words = machine.picture();
  for (const int row : {0, 511, 512, 1079}) {
    const auto dac = frame_scanout_core::pixel(words, row, 1919, k.store());
    EXPECT_EQ(dac.red >> 2, 0x10) << row;
    EXPECT_EQ(dac.green >> 2, 0x20) << row;
    EXPECT_EQ(dac.blue >> 2, 0x30) << row;
  }
  EXPECT_EQ(machine.counters().blocks, 120u * 68);
}

}  // namespace
}  // namespace racebeam
