// Promises of sc/voxel/voxel_walker.h: wired with its partners, models or RTL, it takes rays where
// the closed form takes them, in as many clocks.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sc/voxel/voxel_rays.h"
#include "tb/twin/unit_bench.h"
#include "tests/voxel/knob_sets.h"
#include "tests/voxel/rough_rays.h"
#include "tests/voxel/tiny_world.h"
#include "tests/voxel/walker_rig.h"
#include "tests/voxel/wired_rays.h"

namespace racebeam {
namespace {

template <class Twins>
class Dut {
 public:
  Dut(const voxel_world& world, const voxel_knobs& k)
      : unit_("dut", k),
        bench_(unit_),
        bits_(world.occupancy(), k.memory_clocks),
        columns_(world.columns(), k.memory_clocks) {
    clock();
    bench_["rst_ni"].drive(1);
    clock();
  }

  UnitBench::Pin& operator[](const char* port) { return bench_[port]; }

  void aim(const voxel_ray& ray, const voxel_limit& limit) {
    bench_.drive("origin", "_i", ray.origin);
    bench_.drive("direction", "_i", ray.direction);
    bench_["max_outer_i"].drive(static_cast<unsigned>(limit.outer));
    bench_["max_inner_i"].drive(static_cast<unsigned>(limit.inner));
  }
  /// In a clock in which nothing is looked at, or the last of another ray.
  void start(bool shadow = false) {
    bench_["start_i"].drive(1);
    bench_["shadow_i"].drive(shadow);
    clock();
    bench_["start_i"].drive(0);
    bench_["shadow_i"].drive(0);
    bench_.settle();
  }
  /// From the clock after start() to the last one, which is not over. No t.
  voxel_end end(voxel_walked& walked) {
    for (int clocks = 0; clocks < 100'000; ++clocks) {
      ++walked.clocks;
      const auto state = bench_["state_o"].value();
      walked.descents += state == VoxelDown;
      walked.moves += state == VoxelMove;
      walked.samples += bench_["sample_o"].value();
      walked.words_by_level[0] += bench_["bits_read_o"].value();
      walked.column_reads += bench_["column_read_o"].value();
      if (bench_["ray_done_o"].value())
        return {static_cast<voxel_kind>(bench_["kind_o"].value()), 0, bench_.read("hit")};
      clock();
    }
    throw std::runtime_error("a ray that does not end");
  }
  voxel_end walk(const voxel_ray& ray, const voxel_limit& limit, voxel_walked& walked) {
    aim(ray, limit);
    start();
    const voxel_end found = end(walked);
    clock();
    return found;
  }
  /// The memories answer.
  void clock() {
    bits_.clock(bench_["bits_read_o"].value() != 0, word("bits_address_o"));
    columns_.clock(bench_["column_read_o"].value() != 0, word("column_address_o"));
    bench_.clock();
    bench_["bits_data_i"].drive(bits_.data());
    bench_["column_data_i"].drive(columns_.data());
    bench_.settle();
  }

 private:
  std::uint32_t word(const char* port) { return static_cast<std::uint32_t>(bench_[port].value()); }

  WiredRays<Twins> unit_;
  UnitBench bench_;
  SlowMemory bits_, columns_;
};

void expect_same(const voxel_end& end, const voxel_end& same) {
  ASSERT_EQ(end.kind, same.kind);
  if (same.kind != VoxelSky) {
    ASSERT_EQ(end.position, same.position);
  }
}

template <class Twins>
class VoxelWalkerWired : public testing::Test {
 protected:
  /// Any rays through a rough world.
  static void expect_the_closed_form(const voxel_knobs& k) {
    constexpr unsigned Seed = 7;
    std::mt19937 random(Seed);
    const voxel_world world(voxel_levels(k), rough_columns(random, k));
    Dut<Twins> dut(world, k);
    std::array<int, 4> kinds{};
    for (int n = 0; n < 1500; ++n) {
      SCOPED_TRACE(testing::Message() << "seed " << Seed << ", ray " << n);
      const voxel_ray ray = any_ray(random, k);
      const voxel_limit limit{within(random, 1, 100), within(random, 1, n % 2 ? 100 : 5)};
      voxel_walked walked, expected;
      const voxel_end same = voxel_walk(world, k, ray, limit, expected);
      ASSERT_NO_FATAL_FAILURE(expect_same(dut.walk(ray, limit, walked), same));
      ASSERT_EQ(walked.clocks, expected.clocks);
      ASSERT_EQ(walked.words(), expected.words());
      ASSERT_EQ(walked.descents, expected.descents);
      ASSERT_EQ(walked.moves, expected.moves);
      ASSERT_EQ(walked.samples, expected.samples);
      ASSERT_EQ(walked.column_reads, expected.column_reads);
      ++kinds[same.kind];
    }
    for (const int kind : {VoxelSky, VoxelHit, VoxelOuterLimit}) EXPECT_GT(kinds[kind], 10) << kind;
    if (k.leaf == VoxelLeafMarch) {
      EXPECT_GT(kinds[VoxelInnerLimit], 10);
    }
  }
};
using Kinds = testing::Types<AllModels, AllRtl>;
TYPED_TEST_SUITE(VoxelWalkerWired, Kinds);

TYPED_TEST(VoxelWalkerWired, GoesThroughTallVoxels) { this->expect_the_closed_form(tiny_set()); }
TYPED_TEST(VoxelWalkerWired, GoesThroughCubesThatAreHits) {
  this->expect_the_closed_form(cubes_set());
}
TYPED_TEST(VoxelWalkerWired, GoesThroughAWorldOfOddSides) {
  this->expect_the_closed_form(odd_set());
}
TYPED_TEST(VoxelWalkerWired, GoesThroughLargeVoxels) { this->expect_the_closed_form(coarse_set()); }
TYPED_TEST(VoxelWalkerWired, GoesThroughAWorldOfOneLevel) {
  this->expect_the_closed_form(one_level_set());
}

TYPED_TEST(VoxelWalkerWired, DrawsLinesOfTheWorldTiny) {
  const voxel_world tiny = tiny_world(4);
  Dut<TypeParam> dut(tiny, {});
  const auto at = [](int x, int y) {
    return voxel_ray{{32 * 256 + 128, 2 * 256 + 64, 40 * 256},
                     {(-6710880 + x * 209715) >> 8, 10066330 >> 8, (-838866 - y * 209715) >> 8}};
  };
  voxel_walked walked;
  const voxel_end middle = dut.walk(at(32, 24), {100, 100}, walked);
  EXPECT_EQ(middle.kind, VoxelHit);
  EXPECT_EQ(middle.position[0] >> 8, 32);
  EXPECT_EQ(middle.position[1] >> 8, 54);
  EXPECT_EQ(middle.position[2], 9 * 256 + 181) << "9.7070";
  const voxel_end corner = dut.walk(at(0, 0), {100, 100}, walked);
  EXPECT_EQ(corner.position[0] >> 8 & 63, 54);
  EXPECT_EQ(corner.position[1] >> 8 & 63, 33);
  EXPECT_EQ(corner.position[2], 10 * 256 + 175) << "10.6836";
}

TYPED_TEST(VoxelWalkerWired, AShadowRayGoesFromOneAndAHalfUnitsAboveTheHitToTheLight) {
  const voxel_world tiny = tiny_world(4);
  Dut<TypeParam> dut(tiny, {});
  const vec3 light{-14301, 28602, 57204};
  for (int axis = 0; axis < 3; ++axis) {
    const char* const ports[] = {"light_x_i", "light_y_i", "light_z_i"};
    dut[ports[axis]].drive(raw_bits(static_cast<unsigned>(light[axis]), VoxelDirectionBits));
  }
  dut.aim({{63 * 256 + 192, 63 * 256 + 192, 20 * 256}, {-32768, -24576, -4096}}, {40, 40});
  dut.start();
  voxel_walked walked, expected;
  const voxel_end hit = dut.end(walked);
  ASSERT_EQ(hit.kind, VoxelHit);
  voxel_ray shadow{hit.position, light};
  for (int axis = 0; axis < 3; ++axis)
    shadow.origin[axis] += static_cast<int>(std::floor(1.5 * light[axis] / 256));
  const voxel_end same = voxel_walk(tiny, {}, shadow, {40, 40}, expected);
  for (const char* which : {"in the last clock of the ray", "in that of a shadow's ray"}) {
    SCOPED_TRACE(which);
    dut.start(true);
    walked = {};
    ASSERT_NO_FATAL_FAILURE(expect_same(dut.end(walked), same));
    EXPECT_EQ(walked.clocks, expected.clocks);
  }
}

TYPED_TEST(VoxelWalkerWired, RaysFollowEachOtherWithoutAClockBetween) {
  const voxel_world tiny = tiny_world(4);
  Dut<TypeParam> dut(tiny, {});
  dut.aim({{32 * 256, 32 * 256, 20 * 256}, {32768, 16384, 16384}}, {40, 40});
  dut["start_i"].drive(1);
  dut.clock();
  for (int ray = 0; ray < 3; ++ray)
    for (int clock = 1; clock <= 26; ++clock) {
      ASSERT_EQ(dut["ray_done_o"].value(), clock == 26 ? 1u : 0u) << ray << ":" << clock;
      ASSERT_NE(dut["state_o"].value(), static_cast<unsigned>(VoxelIdle));
      dut.clock();
    }
}

TYPED_TEST(VoxelWalkerWired, AResetEndsARay) {
  const voxel_world tiny = tiny_world(4);
  Dut<TypeParam> dut(tiny, {});
  for (const int clocks : {3, 17, 19, 25, 40}) {
    dut.aim({{63 * 256 + 192, 63 * 256 + 192, 20 * 256}, {-32768, -24576, -4096}}, {40, 40});
    dut.start();
    for (int n = 0; n < clocks; ++n) dut.clock();
    ASSERT_NE(dut["state_o"].value(), static_cast<unsigned>(VoxelIdle));
    dut["rst_ni"].drive(0);
    dut.clock();
    dut["rst_ni"].drive(1);
    for (int n = 0; n < 5; ++n) {
      ASSERT_EQ(dut["state_o"].value(), static_cast<unsigned>(VoxelIdle));
      ASSERT_EQ(dut["ray_done_o"].value(), 0u);
      dut.clock();
    }
  }
  voxel_walked walked;
  const voxel_ray ray{{63 * 256 + 192, 63 * 256 + 192, 20 * 256}, {-32768, -24576, -4096}};
  EXPECT_EQ(dut.walk(ray, {40, 40}, walked).kind, VoxelHit);
  EXPECT_EQ(walked.clocks, 201u);
}

}  // namespace
}  // namespace racebeam
