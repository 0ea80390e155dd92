// The block renderer on the bench: both levels alike.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/block_bench.h"

#include <gtest/gtest.h>

#include <vector>

#include "sc/block/engine.h"
#include "tb/bench/block_signal_bench.h"
#include "tb/bench/block_tlm_bench.h"
#include "tests/support/frames_alike.h"

namespace racebeam {
namespace {

/// Two small balls that come nearer.
BlockProgram small_program() {
  BlockProgram program;
  program.set_bodies({{{-2, 0.5, 4}, {0.5, 0, -0.25}, 0.25, {0.25f, 0.75f, 0.5f}},
                      {{1, -1, 5}, {-0.25, 0.5, 0}, 0.25, {0.75f, 0.5f, 0.25f}}});
  return program;
}

/// Pictures at both levels, those that do not follow reached at once.
void expect_levels_alike(const BlockProgram& program, const std::vector<int>& pictures,
                         const block_knobs& k, const BenchWishes& wishes) {
  const WiredBench::Setting setting{block_engine(), k, &program, 100};
  BlockTlmBench tlm(setting, wishes);
  BlockSignalBench signal(setting, wishes);
  for (const int n : pictures) {
    tlm.seek(n);
    signal.seek(n);
    expect_same(block_engine(), signal.render(), tlm.render());
    EXPECT_EQ(signal.words(), tlm.words());
  }
}

TEST(BlockBench, BothLevelsGiveTheSame) { expect_levels_alike(small_program(), {0, 1}, {}, {}); }

TEST(BlockBench, BothLevelsShowTheSameAtThePins) {
  expect_levels_alike(small_program(), {3}, {}, {true});
}

TEST(BlockBench, BothLevelsGiveTheSameWithOtherKnobs) {
  block_knobs k;
  k.cores = 9;
  k.lanes = 2;
  k.background = 0x204060;
  k.size = BlockSize512;
  k.write_buffer_depth = 8;
  k.when_full = WhenFullDrop;
  k.time_skip = 3;
  k.load_bar = 1;
  expect_levels_alike(small_program(), {2, 3}, k, {true});
}

block_knobs with_cone(int root) {
  block_knobs k;
  k.cores = 2 + root;
  k.root = root;
  k.cull = BlockCullCone;
  return k;
}
TEST(BlockBench, BothLevelsGiveTheSameWithConesAndHeronsRoots) {
  expect_levels_alike(small_program(), {1}, with_cone(BlockRootHeron), {true});
}
TEST(BlockBench, BothLevelsGiveTheSameWithConesAndAllDigits) {
  expect_levels_alike(small_program(), {1}, with_cone(BlockRootExact), {true});
}

TEST(BlockBench, BothLevelsGiveTheSameWithShadows) {
  block_knobs k = with_cone(BlockRootHeron);
  k.shadow_rays = 1;
  k.lanes = 2;
  expect_levels_alike(small_program(), {1}, k, {true});
}

TEST(BlockBench, TheBeamShowsACornerOfALargePicture) {
  block_knobs k;
  k.cores = 16;
  k.size = BlockSize1920;
  expect_levels_alike(small_program(), {0}, k, {true});
}

TEST(BlockBench, QuadIsTheSameAtBothLevels) {
  expect_levels_alike(builtin_block_program(), {0}, {}, {});
}

TEST(BlockBench, APictureLeftInTheMiddleIsNotInTheNext) {
  const BlockProgram program = small_program();
  block_knobs k;
  k.cull = BlockCullOff;  // 1.1 frames
  const WiredBench::Setting setting{block_engine(), k, &program, 100};
  BlockSignalBench left(setting, {});
  left.advance(Raster(block_knobs::clocks_per_pixel).frame_clocks());
  EXPECT_TRUE(left.around()->busy());
  left.seek(5);
  BlockTlmBench tlm(setting, {});
  tlm.seek(5);
  expect_same(block_engine(), left.render(), tlm.render());
}

}  // namespace
}  // namespace racebeam
