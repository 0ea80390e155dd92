// Promises of sc/sphere/sphere_table.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_table.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tb/twin/unit_bench.h"
#include "tests/sphere/twins.h"

namespace racebeam {
namespace {

const char* const Fields[] = {"radius", "radius2", "inverse", "reflect",
                              "red",    "green",   "blue",    "is_light"};

/// Every field of entry `index` is made of `seed`.
template <class Bench>
void write(Bench& b, unsigned index, unsigned last, unsigned seed) {
  std::mt19937 random(seed);
  b["table_write_i"].drive(1);
  b["table_index_i"].drive(index);
  b["table_last_i"].drive(last);
  for (const char* axis : {"x", "y", "z"})
    b[std::string("table_centre_") + axis + "_i"].drive(random() & 0xffffff);
  for (const char* field : Fields) {
    auto& pin = b[std::string("table_") + field + "_i"];
    pin.drive(random() & low_bits(pin.bits));
  }
  b.clock();
  b["table_write_i"].drive(0);
}

template <class Bench>
void expect(Bench& b, unsigned index, unsigned seed, unsigned mask = 0xffffff) {
  std::mt19937 random(seed);
  b["index_i"].drive(index);
  b.settle();
  for (const char* axis : {"x", "y", "z"})
    ASSERT_EQ(b[std::string("centre_") + axis + "_o"].value(), random() & mask) << index;
  for (const char* field : Fields) {
    auto& pin = b[std::string(field) + "_o"];
    ASSERT_EQ(pin.value(), random() & low_bits(pin.bits)) << field << " of " << index;
  }
}

template <class Unit>
class SphereTableTest : public testing::Test {};
TYPED_TEST_SUITE(SphereTableTest, sphere_twins<sphere_table>);

TYPED_TEST(SphereTableTest, EntriesKeepAllTheirBits) {
  TypeParam unit("dut", sphere_knobs{});
  UnitBench b(unit);
  for (unsigned n = 0; n < 16; ++n) write(b, n, n, 100 + n);
  for (unsigned n = 0; n < 16; ++n) expect(b, n, 100 + n);
  EXPECT_EQ(b["last_o"].value(), 15u);
}

TYPED_TEST(SphereTableTest, WriteIsReadFromTheNextClockOn) {
  TypeParam unit("dut", sphere_knobs{});
  UnitBench b(unit);
  write(b, 3, 4, 1);
  b["index_i"].drive(3);
  b["table_write_i"].drive(1);
  b["table_radius_i"].drive(77);
  b.settle();
  EXPECT_NE(b["radius_o"].value(), 77u);
  b.clock();
  EXPECT_EQ(b["radius_o"].value(), 77u);
}

TYPED_TEST(SphereTableTest, NothingIsWrittenWithoutAnEnable) {
  TypeParam unit("dut", sphere_knobs{});
  UnitBench b(unit);
  write(b, 3, 4, 1);
  b["table_radius_i"].drive(77);
  b["table_last_i"].drive(9);
  b.clock(3);
  expect(b, 3, 1);
  EXPECT_EQ(b["last_o"].value(), 4u);
}

TYPED_TEST(SphereTableTest, EntriesBeyondTheTableAreLostAndReadZero) {
  sphere_knobs k;
  k.table_entries = 5;
  TypeParam unit("dut", k);
  UnitBench b(unit);
  write(b, 4, 4, 1);
  write(b, 5, 5, 2);
  expect(b, 4, 1);
  b["index_i"].drive(5);
  b.settle();
  EXPECT_EQ(b["radius2_o"].value(), 0u);
  EXPECT_EQ(b["last_o"].value(), 4u);
}

TYPED_TEST(SphereTableTest, FewerFractionBitsAreCutFromCentres) {
  sphere_knobs k;
  k.fraction_bits = 7;
  TypeParam unit("dut", k);
  UnitBench b(unit);
  write(b, 2, 4, 5);
  expect(b, 2, 5, 0xffffe0);
}

}  // namespace
}  // namespace racebeam
