// Promises of sc/voxel/voxel_shade.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_shade.h"

#include <gtest/gtest.h>

#include <random>

#include "tb/twin/unit_bench.h"
#include "tests/voxel/shaded_ray.h"
#include "tests/voxel/twins.h"
#include "tests/voxel/walker_rig.h"

namespace racebeam {
namespace {

/// A unit beside the columns of a world.
template <class Unit>
struct Dut {
  const voxel_knobs knobs;
  voxel_world world;
  Unit unit;
  UnitBench bench;
  SlowMemory memory;
  voxel_palette palette{};
  int reads = 0;

  explicit Dut(const voxel_knobs& k = {})
      : knobs(k),
        world{voxel_levels(k)},
        unit("dut", k),
        bench(unit),
        memory(world.columns(), k.memory_clocks) {
    bench.clock();
    bench["rst_ni"].drive(1);
    set("put_ready_i", 1);
  }

  void set(const char* port, std::uint64_t value) { bench[port].drive(value); }
  std::uint64_t out(const char* port) { return bench[port].value(); }
  void clock() {
    set("data_i", memory.data());
    bench.settle();
    const bool read = out("read_o");
    const auto address = static_cast<std::uint32_t>(out("address_o"));
    reads += read;
    bench.clock();
    memory.clock(read, address);
    set("data_i", memory.data());
    bench.settle();
  }
  void write_palette(int index, int colour) {
    palette[static_cast<std::size_t>(index)] = colour;
    set("palette_write_i", 1);
    set("palette_index_i", static_cast<std::uint64_t>(index));
    set("palette_colour_i", static_cast<std::uint64_t>(colour));
    clock();
    set("palette_write_i", 0);
  }
  void put_column(int x, int y, const voxel_column& c) {
    world.columns()[world.column_address(x, y)] = packed(c);
  }

  /// As voxel_leaf does before a ray's end, of a hit with leaf = voxel it does not.
  void read_column(int x, int y) {
    set("leaf_read_i", 1);
    set("leaf_address_i", world.column_address(x, y));
    clock();
    set("leaf_read_i", 0);
    for (int n = 0; n < knobs.memory_clocks; ++n) clock();
  }
  void take(const voxel_pixel& pixel, bool shades) {
    bench.drive("hit", "_i", pixel.position);
    set("kind_i", pixel.kind);
    bench["direction_z_i"].drive(static_cast<std::uint64_t>(pixel.direction_z));
    set("take_i", 1);
    set("shade_i", shades);
    set("shadowed_i", shades && pixel.shadowed);
    clock();
    set("take_i", 0);
    set("shade_i", 0);
  }
  /// Of a pixel that begins with the next clock.
  voxel_shaded finish() {
    reads = 0;
    for (int clocks = 1; clocks < 1000; ++clocks) {
      const bool done = out("done_o");
      const auto colour = static_cast<int>(out("colour_o"));
      clock();
      if (done) return {colour, reads, clocks};
    }
    ADD_FAILURE() << "it does not end";
    return {};
  }
  voxel_shaded shade(const voxel_pixel& pixel) {
    const int x = pixel.position[0] >> 8, y = pixel.position[1] >> 8;
    const bool walker_reads = pixel.kind != VoxelHit || knobs.leaf == VoxelLeafMarch;
    if (pixel.kind != VoxelSky && walker_reads) read_column(x, y);
    take(pixel, true);
    return finish();
  }
};

/// In the middle of the cell, going down.
voxel_pixel hit_at(int x, int y, int z) {
  return {VoxelHit, {x * 256 + 128, y * 256 + 128, z * 256 + 128}, -1000, false};
}

template <class Unit>
class VoxelShadeTest : public testing::Test {};
TYPED_TEST_SUITE(VoxelShadeTest, voxel_twins<voxel_shade>);

TYPED_TEST(VoxelShadeTest, AColourIsThatOfMaterialAndHeightInOneClock) {
  Dut<TypeParam> d;
  d.put_column(3, 5, {20, 24, 30, 6, 1});
  d.write_palette(6 * 16 + 9, 0x123456);
  d.write_palette(6 * 16 + 8, 0x654321);
  d.write_palette(1 * 16 + 13, 0xfedcba);
  for (const auto& [z, colour] : {std::pair{19, 0x123456}, {18, 0x123456}, {17, 0x654321}}) {
    const voxel_shaded shaded = d.shade(hit_at(3, 5, z));
    EXPECT_EQ(shaded.colour, colour) << z;
    EXPECT_EQ(shaded.clocks, 1);
    EXPECT_EQ(shaded.reads, 0);
  }
  EXPECT_EQ(d.shade(hit_at(3, 5, 26)).colour, 0xfedcba) << "the upper solid";
}

TYPED_TEST(VoxelShadeTest, AShadowHalvesEachChannel) {
  Dut<TypeParam> d;
  d.put_column(3, 5, {20, 20, 20, 2, 0});
  d.write_palette(2 * 16 + 9, 0xff8103);
  d.read_column(3, 5);
  voxel_pixel pixel = hit_at(3, 5, 19);
  d.take(pixel, false);
  // The ray to the light reads other columns.
  d.read_column(40, 41);
  EXPECT_EQ(d.out("done_o"), 0u);
  d.set("shade_i", 1);
  d.set("shadowed_i", 1);
  d.clock();
  d.set("shade_i", 0);
  EXPECT_EQ(d.finish().colour, 0x7f4001);
  EXPECT_EQ(d.shade(pixel).colour, 0xff8103) << "the next one is lit";
}

TYPED_TEST(VoxelShadeTest, AStoppedRayShowsTheTopOfTheColumnBeneathIt) {
  Dut<TypeParam> d;
  d.put_column(3, 5, {10, 14, 18, 2, 3});
  d.write_palette(2 * 16 + 4, 0x222222);
  d.write_palette(3 * 16 + 8, 0x333333);
  for (const voxel_kind kind : {VoxelOuterLimit, VoxelInnerLimit}) {
    voxel_pixel pixel = hit_at(3, 5, 30);
    pixel.kind = kind;
    EXPECT_EQ(d.shade(pixel).colour, 0x333333) << "the roof";
    pixel.position[2] = 12 * 256;
    EXPECT_EQ(d.shade(pixel).colour, 0x222222) << "the floor, in a cave";
    pixel.position[2] = -700;
    d.write_palette(2 * 16, 0x444444);
    EXPECT_EQ(d.shade(pixel).colour, 0x444444) << "below the world";
  }
}

TYPED_TEST(VoxelShadeTest, HoldsItsColourUntilTheBufferTakesIt) {
  Dut<TypeParam> d;
  d.put_column(3, 5, {20, 20, 20, 2, 0});
  d.write_palette(2 * 16 + 9, 0xabcdef);
  d.read_column(3, 5);
  d.set("put_ready_i", 0);
  d.take(hit_at(3, 5, 19), true);
  for (int clock = 0; clock < 5; ++clock) {
    ASSERT_EQ(d.out("done_o"), 1u);
    ASSERT_EQ(d.out("colour_o"), 0xabcdefu);
    d.clock();
  }
  d.set("put_ready_i", 1);
  d.clock();
  EXPECT_EQ(d.out("done_o"), 0u);
}

TYPED_TEST(VoxelShadeTest, ReadsOfTheLeafPassInTheSameClock) {
  Dut<TypeParam> d;
  for (const unsigned address : {0u, 4095u, 1234u}) {
    d.set("leaf_address_i", address);
    for (const unsigned read : {0u, 1u}) {
      d.set("leaf_read_i", read);
      d.bench.settle();
      EXPECT_EQ(d.out("read_o"), read);
      EXPECT_EQ(d.out("address_o"), address);
    }
  }
}

template <class Unit>
void expect_slopes() {
  voxel_knobs k;
  k.shading = VoxelShadingSlope;
  Dut<Unit> d(k);
  d.write_palette(5, 0xf08010);
  const auto lit = [](int l) { return (0xf0 * l >> 4) << 16 | (0x80 * l >> 4) << 8 | l; };
  struct row {
    int east, west, north, south, light;
  };
  for (const row& r : {row{10, 10, 10, 10, 10},
                       {12, 10, 10, 10, 6},
                       {10, 12, 10, 10, 14},
                       {10, 10, 13, 10, 7},
                       {10, 10, 10, 13, 13},
                       {11, 10, 10, 15, 13},
                       {14, 10, 10, 10, 2},
                       {14, 10, 10, 11, 3},
                       {10, 13, 10, 10, 15},
                       {10, 12, 10, 12, 15},
                       {31, 0, 31, 0, 2},
                       {0, 31, 0, 31, 15}}) {
    d.put_column(0, 63, {11, 11, 11, 0, 0});
    d.put_column(1, 63, {r.east, r.east, r.east, 0, 0});
    d.put_column(63, 63, {r.west, r.west, r.west, 0, 0});
    d.put_column(0, 0, {r.north, r.north, r.north, 0, 0});
    d.put_column(0, 62, {r.south, r.south, r.south, 0, 0});
    const voxel_shaded shaded = d.shade(hit_at(-64, 127, 10));
    EXPECT_EQ(shaded.colour, lit(r.light)) << r.light;
    EXPECT_EQ(shaded.reads, 4);
    EXPECT_EQ(shaded.clocks, 13);
  }
}
TYPED_TEST(VoxelShadeTest, ASlopeTakesFourColumnsAndThirteenClocks) { expect_slopes<TypeParam>(); }

TYPED_TEST(VoxelShadeTest, UnderARoofSlopesAreThoseOfTheSolidThatIsShown) {
  voxel_knobs k;
  k.shading = VoxelShadingSlope;
  Dut<TypeParam> d(k);
  d.write_palette(5, 0x808080);
  d.write_palette(16 + 10, 0x808080);
  d.put_column(20, 20, {11, 20, 22, 0, 1});
  d.put_column(21, 20, {12, 20, 21, 0, 0});
  d.put_column(19, 20, {10, 20, 22, 0, 0});
  d.put_column(20, 21, {10, 20, 22, 0, 0});
  d.put_column(20, 19, {10, 20, 22, 0, 0});
  EXPECT_EQ(d.shade(hit_at(20, 20, 10)).colour & 255, 0x80 * 6 >> 4) << "the floor: 12 - 10";
  EXPECT_EQ(d.shade(hit_at(20, 20, 21)).colour & 255, 0x80 * 12 >> 4) << "the roof: 21 - 22";
}

TYPED_TEST(VoxelShadeTest, ResetEndsReadsAndLeavesThePalette) {
  voxel_knobs k;
  k.shading = VoxelShadingSlope;
  Dut<TypeParam> d(k);
  d.write_palette(5, 0xa0a0a0);
  d.put_column(20, 20, {11, 11, 11, 0, 0});
  d.take(hit_at(20, 20, 10), true);
  d.clock();
  d.clock();
  d.set("rst_ni", 0);
  d.clock();
  d.set("rst_ni", 1);
  d.reads = 0;
  for (int clock = 0; clock < 20; ++clock) {
    d.clock();
    EXPECT_EQ(d.out("done_o"), 0u);
  }
  EXPECT_EQ(d.reads, 0);
  EXPECT_EQ(d.shade(hit_at(20, 20, 10)).colour, 0x646464) << "10 of 16 parts";
}

// --- Random pixels, against the page and the closed form -----------------------------------------

voxel_knobs knobs_of_round(int round) {
  voxel_knobs k;
  k.shading = round % 2 ? VoxelShadingSlope : VoxelShadingHeight;
  if (round >= 1) {
    k.size_x = 96;
    k.size_y = 32;
    k.voxel_y = 1;
    k.size_z = round == 1 ? 256 : round == 2 ? 8 : 16;
    k.memory_clocks = 5 - round;
    k.sky = VoxelSkyGradient;
    k.leaf = round == 1 ? VoxelLeafMarch : VoxelLeafVoxel;
    k.debug_limits = round == 3;
  }
  return k;
}

template <class Unit>
void expect_random_pixels(int round) {
  const voxel_knobs k = knobs_of_round(round);
  Dut<Unit> d(k);
  std::mt19937 random(static_cast<unsigned>(round + 1));
  for (std::uint32_t& word : d.world.columns()) word = packed(any_column(random, k.size_z));
  for (int n = 0; n < VoxelPaletteEntries; ++n)
    d.write_palette(n, static_cast<int>(random() & 0xffffff));
  std::array<int, 4> kinds{};
  for (int n = 0; n < 1000; ++n) {
    const voxel_pixel pixel = any_pixel(random, d.world);
    const voxel_shaded shaded = d.shade(pixel);
    const voxel_shaded closed = voxel_shade_pixel(d.world, d.palette, k, pixel);
    ASSERT_EQ(shaded.colour, page_colour(d.world, d.palette, k, pixel)) << "pixel " << n;
    ASSERT_EQ(closed.colour, shaded.colour) << "pixel " << n;
    ASSERT_EQ(closed.clocks, shaded.clocks) << "pixel " << n;
    ASSERT_EQ(closed.reads, shaded.reads) << "pixel " << n;
    ++kinds[pixel.kind];
  }
  for (const int count : kinds) EXPECT_GT(count, 100);
}
TYPED_TEST(VoxelShadeTest, IsThePageByHeight) { expect_random_pixels<TypeParam>(0); }
TYPED_TEST(VoxelShadeTest, IsThePageInATallWorldWithSlopes) { expect_random_pixels<TypeParam>(1); }
TYPED_TEST(VoxelShadeTest, IsThePageInALowWorldOfVoxelHits) { expect_random_pixels<TypeParam>(2); }
TYPED_TEST(VoxelShadeTest, IsThePageWithMagentaLimits) { expect_random_pixels<TypeParam>(3); }

}  // namespace
}  // namespace racebeam
