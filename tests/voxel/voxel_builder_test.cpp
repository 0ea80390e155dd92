// Promises of sc/voxel/voxel_builder.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_builder.h"

#include <gtest/gtest.h>

#include <array>
#include <deque>

#include "tb/twin/unit_bench.h"
#include "tests/voxel/plain_build.h"
#include "tests/voxel/tiny_world.h"
#include "tests/voxel/twins.h"

namespace racebeam {
namespace {

voxel_knobs world_of(const vec3& size, const vec3& voxel, int levels = VoxelMaxLevels) {
  voxel_knobs k;
  k.size_x = size[0], k.size_y = size[1], k.size_z = size[2];
  k.voxel_x = voxel[0], k.voxel_y = voxel[1], k.voxel_z = voxel[2];
  k.levels = levels;
  return k;
}

/// A builder with both memories.
template <class Unit>
class Dut {
 public:
  std::array<std::uint64_t, 4> clocks{};  ///< by voxel_builder_state

  explicit Dut(const voxel_knobs& k)
      : world(voxel_levels(k)),
        unit_("dut", k),
        bench(unit_),
        column_(static_cast<std::size_t>(k.memory_clocks)),
        occupancy_(static_cast<std::size_t>(k.memory_clocks)) {
    bench.clock();
    bench["rst_ni"].drive(1);
    bench.settle();
  }

  /// Ends with the clock in which done_o is 1.
  void build(const voxel_rectangle& r) {
    clocks = {};
    start(r);
    bool done = false;
    for (int n = 0; !done && n < 10'000'000; ++n) {
      done = done_.value() != 0;
      ++clocks[state_.value()];
      clock();
    }
    ASSERT_TRUE(done);
    ASSERT_EQ(state_.value(), 0u) << "in the clock after done_o";
    ASSERT_EQ(done_.value(), 1u);
  }
  void start(const voxel_rectangle& r) {
    bench["rect_x_low_i"].drive(static_cast<unsigned>(r.x_low));
    bench["rect_y_low_i"].drive(static_cast<unsigned>(r.y_low));
    bench["rect_x_high_i"].drive(static_cast<unsigned>(r.x_high));
    bench["rect_y_high_i"].drive(static_cast<unsigned>(r.y_high));
    bench["start_i"].drive(1);
    clock();
    bench["start_i"].drive(0);
    bench.settle();
  }
  void clock() {
    move(column_, column_read_, world.columns(), column_address_);
    ASSERT_FALSE(occupancy_read_.value() && occupancy_write_.value());
    if (occupancy_write_.value())
      world.occupancy().at(occupancy_address_.value()) =
          static_cast<std::uint32_t>(occupancy_out_.value());
    move(occupancy_, occupancy_read_, world.occupancy(), occupancy_address_);
    bench.clock();
    bench["column_data_i"].drive(column_.front());
    bench["occupancy_data_i"].drive(occupancy_.front());
    bench.settle();
  }
  void expect_clocks(const PlainBuild& expected) const {
    EXPECT_EQ(clocks[VoxelBuilderIdle], 0u);
    EXPECT_EQ(clocks[VoxelBuilderClear], expected.clear);
    EXPECT_EQ(clocks[VoxelBuilderFill], expected.fill);
    EXPECT_EQ(clocks[VoxelBuilderUp], expected.up);
  }

  voxel_world world;

 private:
  Unit unit_;

 public:
  UnitBench bench;

 private:
  static void move(std::deque<std::uint32_t>& later, UnitBench::Pin& read,
                   const std::vector<std::uint32_t>& words, UnitBench::Pin& address) {
    // What no clock waits for is nonsense.
    later.push_back(read.value() ? words.at(address.value()) : 0xdeadbeef);
    later.pop_front();
  }

  std::deque<std::uint32_t> column_, occupancy_;  // on their way
  UnitBench::Pin& done_ = bench["done_o"];
  UnitBench::Pin& state_ = bench["state_o"];
  UnitBench::Pin& column_read_ = bench["column_read_o"];
  UnitBench::Pin& column_address_ = bench["column_address_o"];
  UnitBench::Pin& occupancy_read_ = bench["occupancy_read_o"];
  UnitBench::Pin& occupancy_write_ = bench["occupancy_write_o"];
  UnitBench::Pin& occupancy_address_ = bench["occupancy_address_o"];
  UnitBench::Pin& occupancy_out_ = bench["occupancy_data_o"];
};

std::uint32_t fnv(const std::vector<std::uint32_t>& words) {
  std::uint32_t hash = 2166136261u;
  for (const std::uint32_t word : words)
    for (int byte = 0; byte < 4; ++byte) hash = (hash ^ (word >> 8 * byte & 255)) * 16777619u;
  return hash;
}

template <class Unit>
class VoxelBuilderTest : public testing::Test {
 protected:
  static void expect_tiny(int side_y, std::uint32_t checksum, std::uint64_t bits) {
    Dut<Unit> dut(world_of({64, 64, 32}, {1, side_y, 1}));
    dut.world.columns() = tiny_columns();
    // What lies there from before does not matter.
    for (int k = 0; k < dut.world.levels().count(); ++k) {
      const vec3& sides = dut.world.levels().level(k).sides;
      for (int n = 0; n < sides[0] * sides[1] * sides[2]; n += 3) {
        const voxel_place at = dut.world.levels().place(k, n % sides[0], n / sides[0] % sides[1],
                                                        n / sides[0] / sides[1]);
        dut.world.occupancy()[at.word] |= 1u << at.bit;
      }
    }
    dut.build({0, 0, 64, 64});
    EXPECT_EQ(fnv(dut.world.occupancy()), checksum);
    EXPECT_EQ(dut.world.bits_set(), bits);
    EXPECT_EQ(dut.bench["columns_o"].value(), 4096u);
    voxel_world plain = dut.world;
    dut.expect_clocks(PlainBuild(plain, {0, 0, 64, 64}));
    EXPECT_EQ(dut.clocks[VoxelBuilderClear], 2u * 64 * 64 * 32 / static_cast<unsigned>(side_y));
  }

  static void expect_changes(voxel_knobs k, int memory_clocks, int count) {
    constexpr unsigned Seed = 18;
    SCOPED_TRACE(testing::Message() << "seed " << Seed);
    std::mt19937 random(Seed);
    k.memory_clocks = memory_clocks;
    Dut<Unit> dut(k);
    const voxel_rectangle all{0, 0, k.size_x, k.size_y};
    change(dut.world, all, random);
    dut.world.build();
    for (int n = 0; n < count; ++n) {
      const voxel_rectangle part = any_rectangle(random, k.size());
      change(dut.world, part, random);
      voxel_world plain = dut.world;
      const PlainBuild expected(plain, part, memory_clocks);
      ASSERT_NO_FATAL_FAILURE(dut.build(part));
      dut.expect_clocks(expected);
      EXPECT_EQ(dut.bench["columns_o"].value(), expected.columns);
      const voxel_world scratch(dut.world.levels(), dut.world.columns());
      ASSERT_EQ(dut.world.occupancy(), scratch.occupancy()) << "change " << n;
    }
  }
};
TYPED_TEST_SUITE(VoxelBuilderTest, voxel_twins<voxel_builder>);

TYPED_TEST(VoxelBuilderTest, BuildsTinyOfFlatVoxels) { this->expect_tiny(4, 0x298de96c, 12409); }
TYPED_TEST(VoxelBuilderTest, BuildsTinyOfCubes) { this->expect_tiny(1, 0x34e9e09e, 37038); }

TYPED_TEST(VoxelBuilderTest, ChangesAreAsInABuildFromScratch) {
  this->expect_changes(world_of({64, 64, 32}, {1, 4, 1}), 1, 20);
}
TYPED_TEST(VoxelBuilderTest, ChangesOfAnOddWorldWithASlowMemory) {
  this->expect_changes(world_of({48, 40, 16}, {2, 1, 2}, 3), 3, 20);
}
TYPED_TEST(VoxelBuilderTest, ChangesOfAWorldOfOneLevel) {
  this->expect_changes(world_of({12, 20, 256}, {4, 4, 4}, 1), 8, 10);
}

TYPED_TEST(VoxelBuilderTest, PassesReadsAndTheHostsWritesThroughWhileItIsIdle) {
  Dut<TypeParam> dut(voxel_knobs{});
  UnitBench& bench = dut.bench;
  std::mt19937 random(3);
  for (int n = 0; n < 500; ++n) {
    const bool walk = random() & 1, leaf = random() & 1, host = random() & 1;
    const std::uint64_t word = random() & low_bits(27), column = random() & low_bits(25),
                        other = random() & low_bits(25);
    bench["walk_read_i"].drive(walk);
    bench["walk_address_i"].drive(word);
    bench["leaf_read_i"].drive(leaf);
    bench["leaf_address_i"].drive(column);
    bench["host_write_i"].drive(host);
    bench["host_address_i"].drive(other);
    bench.settle();
    ASSERT_EQ(bench["occupancy_read_o"].value(), walk);
    ASSERT_EQ(bench["occupancy_address_o"].value(), word);
    ASSERT_EQ(bench["occupancy_write_o"].value(), 0u);
    ASSERT_EQ(bench["column_read_o"].value(), leaf && !host);
    ASSERT_EQ(bench["column_write_o"].value(), host);
    ASSERT_EQ(bench["column_address_o"].value(), host ? other : column);
    ASSERT_EQ(bench["done_o"].value(), 1u);
    if (n % 7 == 0) bench.clock();
  }
}

TYPED_TEST(VoxelBuilderTest, ReadsAndWritesOfOthersAreLostWhileItBuilds) {
  Dut<TypeParam> dut(voxel_knobs{});
  dut.world.columns() = tiny_columns();
  dut.start({19, 29, 22, 31});
  for (const char* pin : {"walk_read_i", "leaf_read_i", "host_write_i"}) dut.bench[pin].drive(1);
  for (const char* pin : {"walk_address_i", "leaf_address_i", "host_address_i"})
    dut.bench[pin].drive(0x1234567);
  dut.bench.settle();
  int reads = 0;
  while (!dut.bench["done_o"].value()) {
    ASSERT_EQ(dut.bench["column_write_o"].value(), 0u);
    ASSERT_NE(dut.bench["occupancy_address_o"].value(), 0x1234567u);
    reads += dut.bench["column_read_o"].value() != 0;
    dut.clock();
  }
  EXPECT_EQ(reads, 3 * 4);
  EXPECT_TRUE(dut.world.occupied(0, 20, 7, 19));
}

TYPED_TEST(VoxelBuilderTest, LeavesARectangleAloneThatIsEmptyOrBeyondTheWorld) {
  Dut<TypeParam> dut(voxel_knobs{});
  for (const voxel_rectangle& bad : {voxel_rectangle{5, 0, 5, 9},
                                     {0, 9, 4, 9},
                                     {9, 0, 8, 9},
                                     {0, 9, 9, 8},
                                     {0, 0, 65, 64},
                                     {0, 0, 64, 65},
                                     {0, 0, 32767, 1}}) {
    dut.start(bad);
    EXPECT_EQ(dut.bench["state_o"].value(), 0u);
    EXPECT_EQ(dut.bench["done_o"].value(), 1u);
  }
  dut.start({63, 63, 64, 64});
  EXPECT_EQ(dut.bench["state_o"].value(), static_cast<unsigned>(VoxelBuilderClear));
  EXPECT_EQ(dut.bench["done_o"].value(), 0u);
}

TYPED_TEST(VoxelBuilderTest, AResetEndsABuild) {
  Dut<TypeParam> dut(voxel_knobs{});
  dut.world.columns() = tiny_columns();
  for (const int clocks : {100, 300, 700}) {
    dut.start({0, 0, 2, 4});
    for (int n = 0; n < clocks; ++n) dut.clock();
    ASSERT_EQ(dut.bench["done_o"].value(), 0u);
    dut.bench["rst_ni"].drive(0);
    dut.clock();
    dut.bench["rst_ni"].drive(1);
    dut.bench.settle();
    ASSERT_EQ(dut.bench["state_o"].value(), 0u);
    ASSERT_EQ(dut.bench["done_o"].value(), 1u);
    ASSERT_EQ(dut.bench["columns_o"].value(), 0u);
  }
  ASSERT_NO_FATAL_FAILURE(dut.build({0, 0, 64, 64}));
  EXPECT_EQ(fnv(dut.world.occupancy()), 0x298de96cu);
}

TYPED_TEST(VoxelBuilderTest, AStartWhileItBuildsIsNotLookedAt) {
  Dut<TypeParam> dut(voxel_knobs{});
  dut.start({0, 0, 1, 4});
  dut.bench["start_i"].drive(1);
  dut.bench["rect_x_high_i"].drive(64);
  dut.bench.settle();
  while (!dut.bench["done_o"].value()) dut.clock();
  dut.clock();
  EXPECT_EQ(dut.bench["state_o"].value(), 0u);
  EXPECT_EQ(dut.bench["columns_o"].value(), 4u);
  dut.clock();
  EXPECT_EQ(dut.bench["state_o"].value(), static_cast<unsigned>(VoxelBuilderClear));
}

}  // namespace
}  // namespace racebeam
