// Promises of sc/block/block_convert.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_convert.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>

#include "tb/twin/unit_bench.h"
#include "tests/block/twins.h"

namespace racebeam {
namespace {

constexpr int One = 1 << 20;

std::uint32_t bits_of(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}
float float_of(std::uint32_t bits) {
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// In doubles, which have room for all of it.
std::int64_t reference(float value) {
  const double units = std::nearbyint(static_cast<double>(value) * 16384);
  return std::abs(value) <= 256 && units < 0x400000 ? static_cast<std::int64_t>(units) * 64 : 0;
}

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;

  explicit Dut(const block_knobs& k = {}) : unit("dut", k), bench(unit) {
    bench.clock();
    bench["rst_ni"].drive(1);
    bench.clock();
  }
  void offer(int field, std::uint32_t bits, unsigned index = 0) {
    bench["valid_i"].drive(1);
    bench["field_i"].drive(static_cast<unsigned>(field));
    bench["index_i"].drive(index);
    bench["float_i"].drive(bits);
    bench.settle();
  }
  void give(int field, float value, unsigned index = 0) {
    offer(field, bits_of(value), index);
    bench.clock();
    bench["valid_i"].drive(0);
    bench.settle();
  }
  void give_world() {
    const float eye[] = {0, 1, -7}, light[] = {-8, 9, -9};
    for (int k = 0; k < 3; ++k) {
      give(BlockEyeX + k, eye[k]);
      give(BlockLightX + k, light[k]);
    }
    give(BlockScreenWidth, 8);
    give(BlockScreenHeight, 6);
  }
  std::int64_t fixed() { return bench["fixed_o"].signed_value(); }
  std::uint64_t raw() { return bench["fixed_o"].value(); }
};

template <class Unit>
class BlockConvertTest : public testing::Test {};
TYPED_TEST_SUITE(BlockConvertTest, block_twins<block_convert>);

TYPED_TEST(BlockConvertTest, NumbersOfTheTable) {
  Dut<TypeParam> d;
  const struct {
    float value;
    std::uint32_t fixed;
  } table[] = {{1.0f, 0x00100000},
               {-1.0f, 0xfff00000},
               {3.14159265f, 0x00324400},
               {-2.7182818f, 0xffd48200},
               {255.9f, 0x0ffe6680},
               {-255.9f, 0xf0019980},
               {0.0001f, 0x00000080},
               {100.25f, 0x06440000},
               {0.0f, 0},
               {-0.0f, 0},
               {-256.0f, 0xf0000000}};
  for (const auto& row : table) {
    d.offer(BlockRed, bits_of(row.value));
    EXPECT_EQ(d.raw(), row.fixed) << row.value;
  }
}

TYPED_TEST(BlockConvertTest, TiesGoToEven) {
  Dut<TypeParam> d;
  for (int n = -9; n <= 9; n += 2) {
    d.offer(BlockRed, bits_of(static_cast<float>(n) / 32768));
    EXPECT_EQ(d.fixed() % 128, 0) << n;
    EXPECT_NEAR(static_cast<double>(d.fixed()), n * 32, 32) << n;
  }
}

TYPED_TEST(BlockConvertTest, NumbersThatDoNotFitAreNothing) {
  Dut<TypeParam> d;
  for (const float value : {256.0f, 255.99999f, -256.00003f, 1e30f, -1e30f, HUGE_VALF, -HUGE_VALF,
                            1e-30f, -1e-40f, std::nanf("")}) {
    d.offer(BlockRed, bits_of(value));
    EXPECT_EQ(d.raw(), 0u) << value;
  }
}

TYPED_TEST(BlockConvertTest, RandomNumbersAreRounded) {
  constexpr unsigned Seed = 12;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  std::mt19937 random(Seed);
  Dut<TypeParam> d;
  for (int n = 0; n < 20'000; ++n) {
    std::uint32_t bits = (random() & 0x807fffff) | static_cast<std::uint32_t>(100 + random() % 36)
                                                       << 23;
    if (n % 3 == 0) bits &= ~std::uint32_t{0xfff};
    d.offer(BlockRed, bits);
    ASSERT_EQ(d.fixed(), reference(float_of(bits))) << std::hex << bits;
  }
}

TYPED_TEST(BlockConvertTest, FractionBitsAreCut) {
  block_knobs k;
  k.fraction_bits = 12;
  Dut<TypeParam> d(k);
  d.offer(BlockRed, bits_of(3.14159265f));
  EXPECT_EQ(d.raw(), 0x00324400u & 0xffffff00);
  d.offer(BlockRed, bits_of(-0.0001f));
  EXPECT_EQ(d.raw(), 0xffffff00) << "downwards";
}

TYPED_TEST(BlockConvertTest, SphereIsTheTables) {
  Dut<TypeParam> d;
  d.give_world();
  d.give(BlockEyeY, 0);
  const float sphere[] = {0.5f, 2, 1, 0.75f, 0.75f, 0.75f, 0.25f};
  for (int field = BlockCentreX; field <= BlockBlue; ++field) {
    d.offer(field, bits_of(sphere[field]), 3);
    EXPECT_EQ(d.bench["ready_o"].value(), 1u);
    EXPECT_EQ(d.bench["write_o"].value(), 1u) << field;
    EXPECT_EQ(d.bench["field_o"].value(), static_cast<unsigned>(field));
    EXPECT_EQ(d.bench["index_o"].value(), 3u);
    EXPECT_EQ(d.fixed(), reference(sphere[field]));
    EXPECT_EQ(d.bench["eye_k_o"].signed_value(), field == BlockCentreZ ? -7 * One : 0);
    d.bench.clock();
  }
  d.bench["index_i"].drive(9);
  const int fields[] = {BlockRadius2, BlockRv, BlockRv};
  const std::uint64_t written[] = {0x00090000, 0, 0xfbc50000};
  for (int n = 0; n < 3; ++n) {
    EXPECT_EQ(d.bench["ready_o"].value(), 0u);
    EXPECT_EQ(d.bench["write_o"].value(), n == 1 ? 0u : 1u);
    if (n != 1) {
      EXPECT_EQ(d.bench["field_o"].value(), static_cast<unsigned>(fields[n]));
      EXPECT_EQ(d.bench["index_o"].value(), 3u);
      EXPECT_EQ(d.raw(), written[n]);
      EXPECT_EQ(d.bench["eye_k_o"].value(), 0u);
    }
    d.bench.clock();
  }
  EXPECT_EQ(d.bench["ready_o"].value(), 1u) << "10 clocks a sphere";
}

TYPED_TEST(BlockConvertTest, NumbersWaitForThoseThatFollow) {
  Dut<TypeParam> d;
  d.give_world();
  d.give(BlockBlue, 1);
  d.offer(BlockEyeX, bits_of(5));
  for (int n = 0; n < 3; ++n) {
    EXPECT_EQ(d.bench["ready_o"].value(), 0u);
    EXPECT_EQ(d.bench["eye_x_o"].value(), 0u);
    d.bench.clock();
  }
  d.bench.clock();
  EXPECT_EQ(d.bench["eye_x_o"].value(), 5u * One);
}

TYPED_TEST(BlockConvertTest, WorldStaysInRegisters) {
  Dut<TypeParam> d;
  d.give_world();
  EXPECT_EQ(d.bench.read("eye"), (vec3{0, One, -7 * One}));
  EXPECT_EQ(d.bench.read("light"), (vec3{-8 * One, 9 * One, -9 * One}));
  EXPECT_EQ(d.bench.read("start"), (vec3{-4 * One, 3 * One - One, 7 * One}));
  d.offer(BlockCentreY, 0);
  EXPECT_EQ(d.bench["eye_k_o"].value(), static_cast<unsigned>(One));
}

TYPED_TEST(BlockConvertTest, WorldIsNotWrittenToTheSpheres) {
  Dut<TypeParam> d;
  for (int field = BlockRv; field <= BlockRadius2; ++field) {
    d.offer(field, bits_of(1));
    EXPECT_EQ(d.bench["write_o"].value(), 0u) << field;
  }
  d.offer(BlockRed, bits_of(1));
  d.bench["valid_i"].drive(0);
  d.bench.settle();
  EXPECT_EQ(d.bench["write_o"].value(), 0u);
}

TYPED_TEST(BlockConvertTest, ResetForgetsTheWorldAndWhatFollows) {
  Dut<TypeParam> d;
  d.give_world();
  d.give(BlockBlue, 1);
  d.bench["rst_ni"].drive(0);
  d.bench.clock();
  EXPECT_EQ(d.bench["ready_o"].value(), 1u);
  EXPECT_EQ(d.bench.read("eye"), vec3{});
  EXPECT_EQ(d.bench.read("light"), vec3{});
  EXPECT_EQ(d.bench.read("start"), vec3{});
}

}  // namespace
}  // namespace racebeam
