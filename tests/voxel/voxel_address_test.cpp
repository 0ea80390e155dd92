// Promises of sc/voxel/voxel_address.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_address.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "sc/voxel/voxel_levels.h"
#include "tb/twin/unit_bench.h"
#include "tests/support/scratch_folder.h"
#include "tests/voxel/twins.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;

voxel_knobs world(const vec3& size, const vec3& voxel, int levels = VoxelMaxLevels) {
  voxel_knobs k;
  k.size_x = size[0], k.size_y = size[1], k.size_z = size[2];
  k.voxel_x = voxel[0], k.voxel_y = voxel[1], k.voxel_z = voxel[2];
  k.levels = levels;
  return k;
}

template <class Unit>
class Dut {
 public:
  explicit Dut(const voxel_knobs& k) : levels_(k), unit_("dut", k), bench_(unit_) {}

  struct Place {
    std::uint64_t word, bit;
    bool operator==(const Place& other) const { return word == other.word && bit == other.bit; }
  };
  Place place(int level, int x, int y, int z) {
    drive(level, {x, y, z});
    EXPECT_EQ(bench_["inside_o"].value(), 1u);
    return {bench_["word_o"].value(), bench_["bit_o"].value()};
  }
  bool inside(int level, int x, int y, int z) {
    drive(level, {x, y, z});
    return bench_["inside_o"].value() != 0;
  }
  const voxel_levels& levels() const { return levels_; }

 private:
  void drive(int level, const vec3& voxel) {
    bench_["level_i"].drive(static_cast<unsigned>(level));
    const char* const ports[] = {"x_i", "y_i", "z_i"};
    for (int axis = 0; axis < 3; ++axis)
      bench_[ports[axis]].drive(static_cast<std::uint16_t>(voxel[axis]));
    bench_.settle();
  }

  const voxel_levels levels_;
  Unit unit_;
  UnitBench bench_;
};

template <class Unit>
class VoxelAddressTest : public testing::Test {
 protected:
  using Place = typename Dut<Unit>::Place;

  /// The place of each bit, by the sides of the levels and with nothing but sums.
  static void expect_places(const voxel_knobs& k, int count) {
    constexpr unsigned Seed = 18;
    SCOPED_TRACE(testing::Message() << "seed " << Seed);
    std::mt19937 random(Seed);
    Dut<Unit> dut(k);
    for (int n = 0; n < count; ++n) {
      const int level = static_cast<int>(random() % static_cast<unsigned>(dut.levels().count()));
      const voxel_level& at = dut.levels().level(level);
      vec3 voxel{}, in{}, tile{}, rest{};
      for (int axis = 0; axis < 3; ++axis) {
        voxel[axis] = static_cast<std::int16_t>(random() >> (n % 2 ? 0 : 24));
        in[axis] = voxel[axis];
        while (in[axis] < 0) in[axis] += at.sides[axis] * 16;
        while (in[axis] >= at.sides[axis]) in[axis] -= at.sides[axis];
        tile[axis] = in[axis] / 8, rest[axis] = in[axis] % 8;
      }
      const bool inside = voxel[2] >= 0 && voxel[2] < at.sides[2];
      ASSERT_EQ(dut.inside(level, voxel[0], voxel[1], voxel[2]), inside)
          << level << ":" << voxel[2];
      if (!inside) continue;
      std::uint64_t cell = 0;
      for (int bit = 0; bit < 3; ++bit)
        for (int axis = 0; axis < 3; ++axis)
          cell |= static_cast<std::uint64_t>(rest[axis] >> bit & 1) << (3 * bit + axis);
      const int tiles = (tile[2] * at.tiles[1] + tile[1]) * at.tiles[0] + tile[0];
      const Place expected{at.offset + 16u * static_cast<unsigned>(tiles) + (cell >> 5), cell & 31};
      ASSERT_EQ(dut.place(level, voxel[0], voxel[1], voxel[2]), expected)
          << level << ": " << voxel[0] << "," << voxel[1] << "," << voxel[2];
    }
  }
};
TYPED_TEST_SUITE(VoxelAddressTest, voxel_twins<voxel_address>);

TYPED_TEST(VoxelAddressTest, HasThePlacesOfTheWideWorld) {
  using Place = typename Dut<TypeParam>::Place;
  Dut<TypeParam> dut(world({512, 512, 128}, {1, 4, 1}, 7));
  EXPECT_EQ(dut.place(0, 0, 0, 0), (Place{0, 0}));
  EXPECT_EQ(dut.place(0, 511, 127, 127), (Place{262143, 31}));
  EXPECT_EQ(dut.place(0, 100, 50, 60), (Place{121034, 16}));
  EXPECT_EQ(dut.place(0, -1, -1, 0), (Place{16374, 27}));
  EXPECT_EQ(dut.place(1, 17, 33, 9), (Place{268320, 7}));
  EXPECT_EQ(dut.place(3, 12, 5, 7), (Place{299039, 6}));
  EXPECT_EQ(dut.place(6, 7, 1, 1), (Place{299618, 15}));
  EXPECT_EQ(dut.place(0, 600, 130, 5), (Place{184, 20}));
}

TYPED_TEST(VoxelAddressTest, HasThePlacesOfTheLongWorld) {
  using Place = typename Dut<TypeParam>::Place;
  Dut<TypeParam> dut(world({2048, 16384, 256}, {1, 4, 1}));
  EXPECT_EQ(dut.place(0, 2047, 4095, 255), (Place{67108863, 31}));
  EXPECT_EQ(dut.place(4, 100, 200, 10), (Place{76691907, 0}));
}

TYPED_TEST(VoxelAddressTest, GivesEachVoxelOfATileItsBit) {
  Dut<TypeParam> dut(world({16, 16, 8}, {1, 1, 1}));
  for (int z = 0; z < 8; ++z)
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) {
        const auto place = dut.place(0, x + 8, y, z);
        ASSERT_EQ(place.word * 32 + place.bit,
                  512 + voxel_morton(static_cast<unsigned>(x), static_cast<unsigned>(y),
                                     static_cast<unsigned>(z)));
      }
}

TYPED_TEST(VoxelAddressTest, RepeatsAWorldOfPowersOfTwo) {
  this->expect_places(world({512, 512, 128}, {1, 4, 1}), 20'000);
}
TYPED_TEST(VoxelAddressTest, RepeatsAWorldOfOddSides) {
  this->expect_places(world({96, 1120, 32}, {1, 4, 1}, 4), 20'000);
}
TYPED_TEST(VoxelAddressTest, RepeatsAWorldOfOneLevel) {
  this->expect_places(world({3, 16381, 16}, {1, 1, 1}, 1), 20'000);
}

TYPED_TEST(VoxelAddressTest, NothingIsInsideAboveOrBelow) {
  Dut<TypeParam> dut(world({64, 64, 32}, {1, 4, 1}));
  for (int level = 0; level < dut.levels().count(); ++level) {
    const int top = dut.levels().level(level).sides[2];
    EXPECT_TRUE(dut.inside(level, 5, 5, 0));
    EXPECT_TRUE(dut.inside(level, -5, 500, top - 1));
    EXPECT_FALSE(dut.inside(level, 5, 5, top));
    EXPECT_FALSE(dut.inside(level, 5, 5, -1));
    EXPECT_FALSE(dut.inside(level, 5, 5, 32767));
    EXPECT_FALSE(dut.inside(level, 5, 5, -32768));
  }
}

/// What yosys makes of a unit, before gates.
std::string netlist(const std::string& unit, const std::string& parameters) {
  ScratchFolder folder;
  const std::string out = folder / "netlist.v";
  const std::string command =
      "'" RACEBEAM_SOURCE_DIR "/scripts/netlist' " + unit + " '" + out + "' " + parameters;
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::ifstream file(out);
  return {std::istreambuf_iterator<char>(file), {}};
}

// One that has both shows that they would be seen.
TEST(VoxelAddressRtl, HasNeitherRegistersNorMultipliers) {
  for (const char* world :
       {"", "SizeX=2048 SizeY=16384 SizeZ=256 Levels=9", "SizeX=96 SizeY=1120 SizeZ=32 Levels=4"}) {
    const std::string text = netlist("voxel_address", world);
    EXPECT_THAT(text, HasSubstr("module voxel_address"));
    EXPECT_THAT(text, Not(HasSubstr("posedge")));
    EXPECT_THAT(text, Not(HasSubstr(" * ")));
    EXPECT_THAT(text, Not(HasSubstr(" % ")));
    EXPECT_THAT(text, Not(HasSubstr(" / ")));
  }
  const std::string other = netlist("block_lane", "");
  EXPECT_THAT(other, HasSubstr("posedge"));
  EXPECT_THAT(other, HasSubstr(" * "));
}

}  // namespace
}  // namespace racebeam
