// The wired block renderer and block_machine draw the same pictures in the same clocks.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <random>

#include "tests/block/chip_and_machine.h"
#include "tests/block/few_spheres.h"
#include "tests/support/block_scenes.h"

namespace racebeam {
namespace {

void expect_picture(const block_knobs& k, const block_tables& tables) {
  ChipAndMachine both(k, tables);
  ASSERT_NO_FATAL_FAILURE(both.draw());
  both.expect_same();
}

block_knobs with_cores(int cores) {
  block_knobs k;
  k.cores = cores;
  return k;
}

TEST(BlockChip, TwoPicturesOnOneCoreAreTheMachines) {
  ChipAndMachine both(with_cores(1), few_tables());
  for (int picture = 0; picture < 2; ++picture) {
    ASSERT_NO_FATAL_FAILURE(both.draw());
    both.expect_same();
  }
}

TEST(BlockChip, PictureOnThreeCoresIsTheMachines) { expect_picture(with_cores(3), few_tables()); }
TEST(BlockChip, PictureOnSixteenCoresIsTheMachines) {
  expect_picture(with_cores(16), few_tables());
}

TEST(BlockChip, PictureWithoutSpheresIsTheMachines) {
  block_knobs k = with_cores(5);
  k.background = 0x123456;
  expect_picture(k, {});
}

TEST(BlockChip, StallsOfASmallBufferAreTheMachines) {
  block_knobs k = with_cores(8);
  k.write_buffer_depth = 4;
  k.write_policy = WritePolicyBlanking;
  ChipAndMachine both(k, few_tables());
  ASSERT_NO_FATAL_FAILURE(both.draw());
  EXPECT_GT(both.counters().buffer_stalls, 0u);
  both.expect_same();
}

TEST(BlockChip, LostWordsAreTheMachines) {
  block_knobs k = with_cores(8);
  k.write_policy = WritePolicySync;
  k.when_full = WhenFullDrop;
  ChipAndMachine both(k, few_tables());
  ASSERT_NO_FATAL_FAILURE(both.draw());
  EXPECT_GT(both.counters().buffer_lost, 0u);
  both.expect_same();
}

TEST(BlockChip, OtherNumbersAreTheMachines) {
  block_knobs k = with_cores(2);
  k.lanes = 2;
  k.newton_steps = 1;
  k.specular_squarings = 1;
  k.max_passes = 1;
  k.fraction_bits = 14;
  k.background = 0x804020;
  k.size = BlockSize512;
  expect_picture(k, few_tables());
}

TEST(BlockChip, OneLaneAndEightPassesAreTheMachines) {
  block_knobs k = with_cores(2);
  k.lanes = 1;
  k.max_passes = 8;
  expect_picture(k, few_tables());
}

TEST(BlockChip, ConesAndHeronsRootsAreTheMachines) {
  block_knobs k = with_cores(2);
  k.cull = BlockCullCone;
  k.root = BlockRootHeron;
  expect_picture(k, few_tables());
}

TEST(BlockChip, RootsDigitByDigitAreTheMachines) {
  block_knobs k = with_cores(3);
  k.root = BlockRootExact;
  expect_picture(k, few_tables());
}

TEST(BlockChip, RandomStallsOfTheBusLoseNoWord) {
  constexpr unsigned Seed = 3;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  std::mt19937 random(Seed);
  const block_knobs k = with_cores(5);
  block_chip chip("block", k);
  UnitBench bench(chip);
  // Over what write_buffer says; it may get a word twice.
  bench.between_edges([&] {
    const bool room =
        static_cast<int>(chip.fill.read()) < k.write_buffer_depth || chip.take_ready.read();
    chip.put_ready.write(room && random() % 3 == 0);
  });
  SceneSender(bench, few_tables(), k).send([&] { bench.clock(); });
  int clocks = 0;
  for (; (!bench["done_o"].value() || chip.take_valid.read()) && clocks < 2'000'000; ++clocks)
    bench.clock();
  block_machine machine(k);
  machine.draw(few_tables());
  EXPECT_GT(clocks, 2 * static_cast<int>(machine.counters().clocks)) << "it is the bus that waits";
  EXPECT_EQ(chip.memory(), machine.picture());
}

TEST(BlockChip, RootsOutOfRangeAndSmallVectorsAreTheMachines) {
  block_tables tables = few_tables();
  tables.balls = {{{0, 0, 14}, 2.875f, {0.5f, 0.5f, 0.5f}}};
  tables.eye[2] = 0.015625f;  // at the screen
  tables.screen = {0.25f, 0.1875f};
  block_knobs k = with_cores(16);
  k.max_passes = 1;
  ChipAndMachine both(k, tables);
  ASSERT_NO_FATAL_FAILURE(both.draw());
  EXPECT_GT(both.counters().small_vectors, 0u);
  EXPECT_GT(both.counters().root_out_of_range, 0u);
  both.expect_same();
}

TEST(BlockChip, QuadOnOneCoreIsTheMachines) { expect_picture(with_cores(1), quad_tables()); }
TEST(BlockChip, QuadOnThreeCoresIsTheMachines) { expect_picture(with_cores(3), quad_tables()); }
TEST(BlockChip, QuadOnSixteenCoresIsTheMachines) { expect_picture(with_cores(16), quad_tables()); }

TEST(LongBlockChip, QuadOn1080RowsAnd64CoresIsTheMachines) {
  block_knobs k = with_cores(64);
  k.lanes = 8;
  k.size = BlockSize1920;
  expect_picture(k, quad_tables());
}

TEST(LongBlockChip, AllBlocksDrawnAreTheMachines) {
  block_knobs k = with_cores(16);
  k.cull = BlockCullOff;
  expect_picture(k, forty_tables());
}

}  // namespace
}  // namespace racebeam
