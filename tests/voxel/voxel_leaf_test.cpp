// Promises of sc/voxel/voxel_leaf.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_leaf.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "sc/voxel/voxel_world.h"
#include "tb/twin/unit_bench.h"
#include "tests/voxel/twins.h"

namespace racebeam {
namespace {

constexpr int One = 1 << VoxelDirectionFraction;  // a unit of direction

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;
  const int sample_clocks;

  explicit Dut(const voxel_knobs& k = {})
      : unit("dut", k), bench(unit), sample_clocks(2 + k.memory_clocks) {
    bench.clock();
    bench["rst_ni"].drive(1);
    bench.clock();
  }
  void ray(const vec3& origin, const vec3& direction) {
    bench.drive("origin", "_i", origin);
    bench.drive("direction", "_i", direction);
  }
  /// A voxel from one t to another; some_o.
  bool start(std::uint64_t from, std::uint64_t to, std::uint64_t step) {
    bench["t_from_i"].drive(from);
    bench["t_to_i"].drive(to);
    bench["step_i"].drive(step);
    bench["start_i"].drive(1);
    bench.settle();
    const bool some = (*this)["some_o"] != 0;
    bench.clock();
    bench["start_i"].drive(0);
    bench.settle();
    return some;
  }
  void column(const voxel_column& c) {
    bench["data_i"].drive(packed(c));
    bench.settle();
  }
  /// The t of each sample of the voxel that was started, with its clocks.
  std::vector<std::uint64_t> samples() {
    std::vector<std::uint64_t> all;
    for (bool goes_on = true; goes_on && all.size() < 1000;) {
      all.push_back((*this)["t_o"]);
      for (int clock = 1; clock <= sample_clocks; ++clock) {
        const bool last = clock == sample_clocks;
        EXPECT_EQ((*this)["read_o"], clock == 1 ? 1u : 0u);
        EXPECT_EQ((*this)["sample_o"], last ? 1u : 0u);
        EXPECT_EQ((*this)["t_o"], all.back());
        if (last) goes_on = (*this)["done_o"] == 0;
        else {
          EXPECT_EQ((*this)["done_o"], 0u);
        }
        bench.clock();
      }
    }
    return all;
  }
  std::uint64_t operator[](const char* port) { return bench[port].value(); }
};

voxel_knobs with_memory_clocks(int clocks) {
  voxel_knobs k;
  k.memory_clocks = clocks;
  return k;
}

template <class Unit>
class VoxelLeafTest : public testing::Test {
 protected:
  using Times = std::vector<std::uint64_t>;

  static void expect_samples(int memory_clocks) {
    Dut<Unit> d(with_memory_clocks(memory_clocks));
    d.ray({0, 0, 100 * 256}, {One, 0, 0});
    ASSERT_TRUE(d.start(1000, 2000, 301));
    EXPECT_EQ(d.samples(), (Times{1150, 1451, 1752}));
    EXPECT_EQ(d["samples_o"], 3u);
    for (int clock = 0; clock < 5; ++clock, d.bench.clock()) {
      ASSERT_EQ(d["read_o"], 0u);
      ASSERT_EQ(d["sample_o"], 0u);
    }
    ASSERT_TRUE(d.start(1000, 1151, 301));
    EXPECT_EQ(d.samples(), Times{1150});
    ASSERT_TRUE(d.start(1000, 1452, 301));
    EXPECT_EQ(d.samples(), (Times{1150, 1451}));
    ASSERT_TRUE(d.start(1000, 1451, 301));
    EXPECT_EQ(d.samples(), Times{1150}) << "not at the end";
  }
};
TYPED_TEST_SUITE(VoxelLeafTest, voxel_twins<voxel_leaf>);

TYPED_TEST(VoxelLeafTest, SamplesHalfAStepInAndEveryStepFromThere) { this->expect_samples(1); }
TYPED_TEST(VoxelLeafTest, SamplesOfASlowMemoryTakeItsClocksMore) { this->expect_samples(3); }

TYPED_TEST(VoxelLeafTest, AVoxelTooShortForASampleHasNone) {
  Dut<TypeParam> d;
  EXPECT_FALSE(d.start(1000, 1150, 301));
  EXPECT_FALSE(d.start(1000, 900, 301));
  for (int clock = 0; clock < 5; ++clock, d.bench.clock()) {
    ASSERT_EQ(d["read_o"], 0u);
    ASSERT_EQ(d["sample_o"], 0u);
  }
}

TYPED_TEST(VoxelLeafTest, SumsOfTDoNotOverflow) {
  using Times = std::vector<std::uint64_t>;
  Dut<TypeParam> d;
  d.ray({0, 0, 100 * 256}, {0, 0, 0});
  EXPECT_FALSE(d.start(0xc0000000, 0x80000000, 0xffffffff));
  ASSERT_TRUE(d.start(0x10, 0x80000000, 0xffff0000));
  EXPECT_EQ(d.samples(), Times{0x7fff8010});
}

TYPED_TEST(VoxelLeafTest, HitsWhatIsSolid) {
  const voxel_column columns[] = {{0, 0, 0}, {5, 5, 5}, {5, 7, 9}, {255, 255, 255}, {0, 0, 200}};
  Dut<TypeParam> d;
  for (const voxel_column& c : columns)
    for (const int z : {-1, 0, 1, 4, 5, 6, 7, 8, 9, 199, 200, 254, 255, 256, 260, 32767, -32768})
      for (const int part : {0, 255}) {
        d.ray({0, 0, z * 256 + part}, {0, 0, 0});
        ASSERT_TRUE(d.start(0, 300, 256));
        d.column(c);
        d.bench.clock(2);
        ASSERT_EQ(d["hit_o"], c.solid(z) ? 1u : 0u) << z << " in " << c.low << "," << c.middle;
        ASSERT_EQ(d["done_o"], 1u);
        d.bench.clock();
        ASSERT_EQ(d["hit_o"], 0u) << "of no sample";
        ASSERT_EQ(d["samples_o"], c.solid(z) ? 0u : 1u);
      }
}

TYPED_TEST(VoxelLeafTest, AHitIsTheLastSample) {
  Dut<TypeParam> d;
  d.ray({0, 0, 10 * 256}, {0, 0, -One});
  d.column({9, 9, 9});
  ASSERT_TRUE(d.start(0, 10'000, 256));
  d.bench.clock(2);
  EXPECT_EQ(d["hit_o"], 0u) << "at 9.5";
  d.bench.clock(3);
  EXPECT_EQ(d["hit_o"], 1u) << "at 8.5";
  EXPECT_EQ(d["done_o"], 1u);
  EXPECT_EQ(d.bench.read("position")[2], 8 * 256 + 128);
  d.bench.clock();
  EXPECT_EQ(d["read_o"], 0u);
  EXPECT_EQ(d["samples_o"], 1u);
  d.bench.clock(5);
  EXPECT_EQ(d["sample_o"], 0u);
  EXPECT_EQ(d["t_o"], 384u);
}

TYPED_TEST(VoxelLeafTest, StopEndsAVoxelAtTheEndOfASampleAlone) {
  Dut<TypeParam> d;
  d.ray({0, 0, 100 * 256}, {0, 0, 0});
  ASSERT_TRUE(d.start(0, 100'000, 256));
  d.bench["stop_i"].drive(1);
  d.bench.clock(2);
  d.bench["stop_i"].drive(0);
  d.bench.settle();
  EXPECT_EQ(d["sample_o"], 1u);
  EXPECT_EQ(d["done_o"], 0u);
  d.bench.clock();
  EXPECT_EQ(d["read_o"], 1u) << "goes on";
  d.bench.clock(2);
  d.bench["stop_i"].drive(1);
  d.bench.settle();
  EXPECT_EQ(d["sample_o"], 1u);
  EXPECT_EQ(d["done_o"], 0u);
  d.bench.clock();
  EXPECT_EQ(d["read_o"], 0u);
  EXPECT_EQ(d["samples_o"], 2u);
}

TYPED_TEST(VoxelLeafTest, CountsSamplesModulo256) {
  Dut<TypeParam> d;
  d.ray({0, 0, 100 * 256}, {0, 0, 0});
  ASSERT_TRUE(d.start(0, 260 * 256, 256));
  EXPECT_EQ(d.samples().size(), 260u);
  EXPECT_EQ(d["samples_o"], 4u);
  ASSERT_TRUE(d.start(0, 256, 256));
  EXPECT_EQ(d["samples_o"], 0u) << "of a new voxel";
}

TYPED_TEST(VoxelLeafTest, IsWhereTheRayIs) {
  constexpr unsigned Seed = 5;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  std::mt19937_64 random(Seed);
  Dut<TypeParam> d;
  d.bench["at_i"].drive(1);
  for (int n = 0; n < 20'000; ++n) {
    vec3 origin{}, direction{};
    for (int axis = 0; axis < 3; ++axis) {
      origin[axis] = static_cast<int>(random() >> 40) - (1 << 23);
      direction[axis] = (static_cast<int>(random() >> 46) - (1 << 17)) >> random() % 17;
    }
    const std::uint64_t t = (random() >> 32) >> random() % 32;
    d.ray(origin, direction);
    d.bench["t_from_i"].drive(t);
    d.bench.settle();
    const vec3 position = d.bench.read("position");
    for (int axis = 0; axis < 3; ++axis) {
      const std::int64_t product = static_cast<std::int64_t>(t) * direction[axis];
      std::int64_t moved = product / 65536;
      if (product % 65536 < 0) --moved;
      const std::int64_t off = origin[axis] + moved - position[axis];
      ASSERT_EQ(off % (1 << 24), 0) << "ray " << n << ", axis " << axis;
    }
  }
}

TYPED_TEST(VoxelLeafTest, ReadsTheColumnOfAWorldThatRepeats) {
  voxel_knobs k;
  k.size_x = 96, k.size_y = 160, k.levels = 4;
  Dut<TypeParam> d(k);
  d.bench["at_i"].drive(1);
  d.bench["fetch_i"].drive(1);
  for (const int x : {0, 1, 95, 96, 1000, 32767, -1, -96, -97, -32768})
    for (const int y : {0, 1, 159, 160, 1000, 32767, -1, -160, -161, -32768}) {
      d.ray({x * 256 + 255, y * 256, 0}, {0, 0, 0});
      d.bench.settle();
      const int in_x = ((x % 96) + 96) % 96, in_y = ((y % 160) + 160) % 160;
      ASSERT_EQ(d["address_o"], static_cast<unsigned>(in_y * 96 + in_x)) << x << "," << y;
      ASSERT_EQ(d["read_o"], 1u);
    }
  d.bench["fetch_i"].drive(0);
  d.bench.settle();
  EXPECT_EQ(d["read_o"], 0u);
}

TYPED_TEST(VoxelLeafTest, AResetEndsASample) {
  Dut<TypeParam> d;
  d.ray({0, 0, 100 * 256}, {0, 0, 0});
  for (const int clocks : {0, 1, 2}) {
    ASSERT_TRUE(d.start(0, 100'000, 256));
    d.bench.clock(clocks);
    d.bench["rst_ni"].drive(0);
    d.bench.clock();
    d.bench["rst_ni"].drive(1);
    for (int clock = 0; clock < 5; ++clock, d.bench.clock()) {
      ASSERT_EQ(d["read_o"], 0u);
      ASSERT_EQ(d["sample_o"], 0u);
    }
  }
}

}  // namespace
}  // namespace racebeam
