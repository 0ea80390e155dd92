// Promises of sc/block/block_spheres.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_spheres.h"

#include <gtest/gtest.h>

#include <string>

#include "tb/twin/unit_bench.h"
#include "tests/block/twins.h"

namespace racebeam {
namespace {

template <class Bench>
void write(Bench& b, unsigned index, unsigned field, unsigned value, unsigned eye = 0) {
  b["write_i"].drive(1);
  b["index_i"].drive(index);
  b["field_i"].drive(field);
  b["value_i"].drive(value);
  b["eye_k_i"].drive(eye);
  b.clock();
  b["write_i"].drive(0);
}

/// Every field of an entry, of `seed`.
template <class Bench>
void fill(Bench& b, unsigned index, unsigned seed) {
  for (unsigned field = 0; field <= BlockRadius2; ++field)
    write(b, index, field, seed + field, 1000);
}
template <class Bench>
void expect(Bench& b, unsigned group, unsigned seed) {
  b["group_i"].drive(group);
  b.settle();
  for (int k = 0; k < 3; ++k) {
    const std::string axis(1, "xyz"[k]);
    const unsigned value = seed + BlockCentreX + static_cast<unsigned>(k);
    ASSERT_EQ(b["centre_" + axis + "_o"].value(), value) << group;
    ASSERT_EQ(b["pose_" + axis + "_o"].value(), (1000 - value) & 0xffffffff) << group;
  }
  ASSERT_EQ(b["red_o"].value(), seed + BlockRed);
  ASSERT_EQ(b["green_o"].value(), seed + BlockGreen);
  ASSERT_EQ(b["blue_o"].value(), seed + BlockBlue);
  ASSERT_EQ(b["radius_o"].value(), seed + BlockRadius);
  ASSERT_EQ(b["radius2_o"].value(), seed + BlockRadius2);
  ASSERT_EQ(b["rv_o"].value(), seed + BlockRv);
}

template <class Unit>
class BlockSpheresTest : public testing::Test {};
TYPED_TEST_SUITE(BlockSpheresTest, block_twins<block_spheres>);

TYPED_TEST(BlockSpheresTest, EntriesKeepAllTheirFields) {
  TypeParam unit("dut", block_knobs{});
  UnitBench b(unit);
  for (unsigned n = 0; n < 16; ++n) fill(b, n, 0x70000000 + 100 * n);
  for (unsigned n = 0; n < 16; ++n) expect(b, n, 0x70000000 + 100 * n);
}

TYPED_TEST(BlockSpheresTest, AWriteIsReadFromTheNextClockOn) {
  TypeParam unit("dut", block_knobs{});
  UnitBench b(unit);
  fill(b, 3, 5);
  b["group_i"].drive(3);
  b["write_i"].drive(1);
  b["field_i"].drive(BlockRed);
  b["value_i"].drive(77);
  b.settle();
  EXPECT_EQ(b["red_o"].value(), 5u + BlockRed);
  b.clock();
  EXPECT_EQ(b["red_o"].value(), 77u);
}

TYPED_TEST(BlockSpheresTest, NothingIsWrittenWithoutAnEnable) {
  TypeParam unit("dut", block_knobs{});
  UnitBench b(unit);
  fill(b, 3, 5);
  b["value_i"].drive(77);
  b.clock(2);
  expect(b, 3, 5);
}

template <class Unit>
void expect_entries(int lanes) {
  block_knobs k;
  k.lanes = lanes;
  Unit unit("dut", k);
  UnitBench b(unit);
  const unsigned entries = 64u / static_cast<unsigned>(lanes);
  fill(b, entries - 1, 500);
  fill(b, 0, 700);
  expect(b, entries - 1, 500);
  expect(b, entries & 63, 700);  // bits above the entries do not count
}
TYPED_TEST(BlockSpheresTest, OneLaneHasAllSpheres) { expect_entries<TypeParam>(1); }
TYPED_TEST(BlockSpheresTest, EightLanesHaveEightEach) { expect_entries<TypeParam>(8); }

}  // namespace
}  // namespace racebeam
