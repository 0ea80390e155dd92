// Promises of sc/voxel/voxel_scan.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_scan.h"

#include <gtest/gtest.h>

#include <string>

#include "tb/twin/unit_bench.h"
#include "tests/voxel/twins.h"

namespace racebeam {
namespace {

voxel_knobs small_picture(int shadows) {
  voxel_knobs k;
  k.picture_width = 8;
  k.picture_height = 3;
  k.max_outer = 90;
  k.max_inner = 80;
  k.shadows = shadows;
  k.shadow_outer = 30;
  k.shadow_inner = 1023;
  return k;
}

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;

  explicit Dut(int shadows = 0) : unit("dut", small_picture(shadows)), bench(unit) {
    bench.clock();
    bench["rst_ni"].drive(1);
    bench.clock();
  }
  std::uint64_t out(const char* port) { return bench[port].value(); }
  void in(const char* port, std::uint64_t value) {
    bench[port].drive(value);
    bench.settle();
  }
  /// A clock with `port` at 1; `look` sees what is in it.
  template <class Look>
  void pulse(const char* port, Look&& look) {
    in(port, 1);
    look();
    bench.clock();
    in(port, 0);
  }
  void pulse(const char* port) {
    pulse(port, [] {});
  }
  void ray_done(int kind) {
    in("kind_i", static_cast<std::uint64_t>(kind));
    pulse("ray_done_i");
  }
  /// Names of the outputs of 1 bit that are 1, but shadow_o.
  std::string pulses() {
    std::string all;
    for (const UnitBench::Pin* pin : bench.pins())
      if (!pin->input && pin->bits == 1 && pin->name != "shadow_o" && pin->value())
        all += (all.empty() ? "" : " ") + pin->name;
    return all;
  }
};

template <class Unit>
class VoxelScanTest : public testing::Test {};
TYPED_TEST_SUITE(VoxelScanTest, voxel_twins<voxel_scan>);

TYPED_TEST(VoxelScanTest, PixelsGoLineByLineLeftToRight) {
  Dut<TypeParam> d;
  EXPECT_EQ(d.pulses(), "");
  EXPECT_EQ(d.out("state_o"), VoxelScanIdle);
  d.pulse("start_i", [&] { EXPECT_EQ(d.pulses(), "camera_start_o start_o"); });
  d.in("put_ready_i", 1);
  for (unsigned row = 0; row < 3; ++row)
    for (unsigned column = 0; column < 8; ++column) {
      EXPECT_EQ(d.out("state_o"), VoxelScanRay);
      d.ray_done(VoxelSky);
      EXPECT_EQ(d.out("state_o"), VoxelScanShade);
      EXPECT_EQ(d.pulses(), "");
      d.in("colour_i", 0x812345 + row * 8 + column);
      d.pulse("done_i", [&] {
        EXPECT_EQ(d.out("put_address_o"), row << 10 | column);
        EXPECT_EQ(d.out("put_data_o"), 0x812345 + row * 8 + column);
        EXPECT_EQ(d.pulses(), column < 7 ? "next_pixel_o start_o put_valid_o"
                              : row < 2  ? "next_line_o start_o put_valid_o"
                                         : "picture_done_o put_valid_o");
      });
    }
  EXPECT_EQ(d.out("state_o"), VoxelScanIdle);
  d.bench.clock(3);
  EXPECT_EQ(d.out("state_o"), VoxelScanIdle);
  d.pulse("start_i", [&] { EXPECT_EQ(d.pulses(), "camera_start_o start_o"); });
  EXPECT_EQ(d.out("put_address_o"), 0u) << "the next picture";
}

TYPED_TEST(VoxelScanTest, TheRayIsTakenAndShadedInItsLastClock) {
  Dut<TypeParam> d;
  d.pulse("start_i");
  for (int clock = 0; clock < 5; ++clock) {
    EXPECT_EQ(d.pulses(), "");
    d.bench.clock();
    EXPECT_EQ(d.out("state_o"), VoxelScanRay);
  }
  d.in("kind_i", VoxelHit);
  d.pulse("ray_done_i", [&] { EXPECT_EQ(d.pulses(), "take_o shade_o"); });
  EXPECT_EQ(d.out("state_o"), VoxelScanShade);
}

TYPED_TEST(VoxelScanTest, WaitsForTheColourAndTheBuffer) {
  Dut<TypeParam> d;
  d.pulse("start_i");
  d.ray_done(VoxelSky);
  d.in("put_ready_i", 1);
  d.bench.clock(4);
  EXPECT_EQ(d.pulses(), "") << "no colour yet";
  d.in("put_ready_i", 0);
  d.in("done_i", 1);
  d.bench.clock(4);
  EXPECT_EQ(d.pulses(), "put_valid_o") << "the buffer is full";
  EXPECT_EQ(d.out("put_address_o"), 0u);
  d.in("put_ready_i", 1);
  EXPECT_EQ(d.pulses(), "next_pixel_o start_o put_valid_o");
  d.bench.clock();
  EXPECT_EQ(d.out("state_o"), VoxelScanRay);
  EXPECT_EQ(d.out("put_address_o"), 1u);
}

TYPED_TEST(VoxelScanTest, AHitIsFollowedByARayToTheLight) {
  Dut<TypeParam> d(1);
  d.in("put_ready_i", 1);
  EXPECT_EQ(d.out("max_outer_o"), 90u);
  EXPECT_EQ(d.out("max_inner_o"), 80u);
  EXPECT_EQ(d.out("shadow_o"), 0u);
  d.pulse("start_i");
  for (const int met : {VoxelSky, VoxelHit, VoxelOuterLimit, VoxelInnerLimit}) {
    d.in("kind_i", VoxelHit);
    d.pulse("ray_done_i", [&] {
      EXPECT_EQ(d.pulses(), "start_o take_o");
      EXPECT_EQ(d.out("shadow_o"), 1u);
      EXPECT_EQ(d.out("max_outer_o"), 30u);
      EXPECT_EQ(d.out("max_inner_o"), 1023u);
    });
    EXPECT_EQ(d.out("state_o"), VoxelScanShadow);
    EXPECT_EQ(d.pulses(), "");
    d.in("kind_i", static_cast<std::uint64_t>(met));
    d.pulse("ray_done_i",
            [&] { EXPECT_EQ(d.pulses(), met == VoxelHit ? "shade_o shadowed_o" : "shade_o"); });
    EXPECT_EQ(d.out("state_o"), VoxelScanShade);
    d.pulse("done_i", [&] {
      EXPECT_EQ(d.pulses(), "next_pixel_o start_o put_valid_o");
      EXPECT_EQ(d.out("shadow_o"), 0u);
      EXPECT_EQ(d.out("max_outer_o"), 90u);
      EXPECT_EQ(d.out("max_inner_o"), 80u);
    });
  }
}

TYPED_TEST(VoxelScanTest, OnlyAHitMayLieInAShadow) {
  Dut<TypeParam> d(1);
  d.in("put_ready_i", 1);
  d.pulse("start_i");
  for (const int kind : {VoxelSky, VoxelOuterLimit, VoxelInnerLimit}) {
    d.in("kind_i", static_cast<std::uint64_t>(kind));
    d.pulse("ray_done_i", [&] { EXPECT_EQ(d.pulses(), "take_o shade_o") << kind; });
    d.pulse("done_i");
  }
}

TYPED_TEST(VoxelScanTest, StartCountsInIdleOnly) {
  Dut<TypeParam> d;
  d.pulse("start_i");
  d.in("start_i", 1);
  EXPECT_EQ(d.pulses(), "");
  d.ray_done(VoxelSky);
  EXPECT_EQ(d.pulses(), "");
  d.bench.clock(2);
  d.in("put_ready_i", 1);
  d.pulse("done_i");
  d.bench.clock(2);
  EXPECT_EQ(d.out("put_address_o"), 1u) << "the picture goes on";
}

TYPED_TEST(VoxelScanTest, ResetForgetsThePlace) {
  Dut<TypeParam> d;
  d.in("put_ready_i", 1);
  d.pulse("start_i");
  for (int pixel = 0; pixel < 11; ++pixel) {
    d.ray_done(VoxelSky);
    d.pulse("done_i");
  }
  EXPECT_EQ(d.out("put_address_o"), 1u << 10 | 3u);
  d.in("rst_ni", 0);
  d.bench.clock();
  d.in("rst_ni", 1);
  EXPECT_EQ(d.out("state_o"), VoxelScanIdle);
  EXPECT_EQ(d.out("put_address_o"), 0u);
}

}  // namespace
}  // namespace racebeam
