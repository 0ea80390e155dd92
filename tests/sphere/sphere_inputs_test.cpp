// Promises of sc/sphere/sphere_inputs.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_inputs.h"

#include <gtest/gtest.h>

#include <string>

#include "sc/sphere/sphere_scene.h"
#include "tb/twin/unit_bench.h"
#include "tests/sphere/twins.h"

namespace racebeam {
namespace {

template <class Unit>
class SphereInputsTest : public testing::Test {
 protected:
  SphereInputsTest() { reset(0, 15); }
  void reset(unsigned sw, unsigned key_n) {
    board(sw, key_n);
    bench["rst_ni"].drive(0);
    bench.clock();
    bench["rst_ni"].drive(1);
    bench.clock();
  }
  void board(unsigned sw, unsigned key_n = 15) {
    bench["sw_i"].drive(sw);
    bench["key_ni"].drive(key_n);
  }
  void picture() {
    bench["picture_done_i"].drive(1);
    bench.clock();
    bench["picture_done_i"].drive(0);
    bench.clock();
  }
  int value(const char* port) { return static_cast<int>(bench[port].value()); }

  const sphere_tables tables;
  Unit unit{"dut", tables};
  UnitBench bench{unit};
};
TYPED_TEST_SUITE(SphereInputsTest, sphere_twins<sphere_inputs>);

constexpr vec3 Eye{0, 0, -32 * 4096}, Light{15 * 4096, 15 * 4096, -4096};

TYPED_TEST(SphereInputsTest, StartsAtTheStartValues) {
  EXPECT_EQ(this->bench.read("origin"), Eye);
  EXPECT_EQ(this->bench.read("light"), Light);
  EXPECT_EQ(this->value("screen_o"), 8 * 4096);
  EXPECT_EQ(this->value("rotz_o"), 0);
}

TYPED_TEST(SphereInputsTest, EachSwitchMovesItsCoordinateByOne) {
  for (int sw = 6; sw < 18; ++sw) {
    this->reset(0, 15);
    this->board(1u << sw);
    this->picture();
    const int axis = sw >= 12 ? (17 - sw) / 2 : (11 - sw) / 2;
    vec3 eye = Eye, light = Light;
    (sw >= 12 ? light : eye)[axis] += sw % 2 ? 4096 : -4096;
    EXPECT_EQ(this->bench.read("origin"), eye) << "SW" << sw;
    EXPECT_EQ(this->bench.read("light"), light) << "SW" << sw;
    EXPECT_EQ(this->value("rotz_o"), 0) << "SW" << sw;
  }
}

TYPED_TEST(SphereInputsTest, BothOfAPairTurnAndMoveNothing) {
  for (int pair = 0; pair < 6; ++pair) {
    this->reset(0, 15);
    this->board(3u << (6 + 2 * pair));
    this->picture();
    EXPECT_EQ(this->value("rotz_o"), 1 << pair);
    EXPECT_EQ(this->bench.read("origin"), Eye);
    EXPECT_EQ(this->bench.read("light"), Light);
    this->board(0);
    this->picture();
    EXPECT_EQ(this->value("rotz_o"), 0);
  }
}

TYPED_TEST(SphereInputsTest, PairBesideASwitchMovesItStill) {
  this->board(3u << 16 | 1u << 11);
  this->picture();
  EXPECT_EQ(this->value("rotz_o"), 32);
  EXPECT_EQ(this->bench.read("origin"), (vec3{4096, 0, -32 * 4096}));
}

TYPED_TEST(SphereInputsTest, KeysWidenAndTelescope) {
  this->board(0, 15 & ~1u);
  this->picture();
  EXPECT_EQ(this->value("screen_o"), 8 * 4096 + 256);
  this->board(0, 15 & ~2u);
  this->picture();
  this->picture();
  EXPECT_EQ(this->value("screen_o"), 8 * 4096 - 256);
  this->board(0, 12);
  this->picture();
  EXPECT_EQ(this->value("screen_o"), 8 * 4096 - 256) << "both";
}

TYPED_TEST(SphereInputsTest, ModesAreTakenAtTheEndOfAPicture) {
  this->board(1u << 5 | 1u << 4 | 2u << 2 | 1u);
  this->bench.clock(5);
  EXPECT_EQ(this->value("narrow_o"), 1);
  EXPECT_EQ(this->value("max_reflections_o"), 0);
  this->picture();
  EXPECT_EQ(this->value("narrow_o"), 0);
  EXPECT_EQ(this->value("scene_o"), 1);
  EXPECT_EQ(this->value("max_reflections_o"), 2);
  EXPECT_EQ(this->value("alias_o"), 1);
  this->board(3);
  this->picture();
  EXPECT_EQ(this->value("alias_o"), 2) << "8x wins";
}

TYPED_TEST(SphereInputsTest, PlanesAreTakenAtResetOnly) {
  this->board(0, 15 & ~4u);
  this->picture();
  EXPECT_EQ(this->value("planes_o"), 0);
  this->reset(0, 15 & ~4u);
  EXPECT_EQ(this->value("planes_o"), 1);
  this->board(0);
  this->picture();
  EXPECT_EQ(this->value("planes_o"), 1);
}

TYPED_TEST(SphereInputsTest, Key3ResetsAtOnce) {
  this->board(1u << 17);
  this->picture();
  this->board(3u << 2, 7);
  this->bench.settle();
  EXPECT_EQ(this->value("rst_no"), 0);
  this->bench.clock();
  EXPECT_EQ(this->bench.read("light"), Light);
  EXPECT_EQ(this->value("max_reflections_o"), 3);
  this->board(0);
  this->bench.settle();
  EXPECT_EQ(this->value("rst_no"), 1);
}

}  // namespace
}  // namespace racebeam
