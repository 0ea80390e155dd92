// Promises of sc/sphere/sphere_shader.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_shader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "tb/twin/unit_bench.h"
#include "tests/sphere/twins.h"

namespace racebeam {
namespace {

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;

  explicit Dut(const sphere_knobs& k = {}) : unit("dut", k), bench(unit) {
    bench.clock();
    bench["rst_ni"].drive(1);
    bench["direct_i"].drive(1);
  }
  void set(const char* port, unsigned value) { bench[port].drive(value); }
  void base(unsigned red, unsigned green, unsigned blue) {
    set("base_red_i", red);
    set("base_green_i", green);
    set("base_blue_i", blue);
  }
  void op(unsigned op) {
    set("op_i", op);
    bench.clock();
    set("op_i", ShadeHold);
  }
  unsigned word() {
    bench.settle();
    return static_cast<unsigned>(bench["word_o"].value());
  }
  unsigned weight() {
    bench.settle();
    return static_cast<unsigned>(bench["weight_o"].value());
  }
};

template <class Unit>
class SphereShaderTest : public testing::Test {};
TYPED_TEST_SUITE(SphereShaderTest, sphere_twins<sphere_shader>);

unsigned word_of(int light, int red, int green, int blue) {
  return static_cast<unsigned>(light << 15 | red << 10 | green << 5 | blue);
}

TYPED_TEST(SphereShaderTest, LitColourIsFractionPlusHalf) {
  Dut<TypeParam> d;
  d.base(31, 16, 1);
  d.set("fraction_i", 0x800);
  d.op(ShadeLit);
  EXPECT_EQ(d.word(), 0u) << "not added yet";
  d.op(ShadeAdd);
  // 992 -> 496 + 496, times 0xfff / 4096: 991
  EXPECT_EQ(d.word(), word_of(0, 991 >> 5, 511 >> 5, 31 >> 5));
}

TYPED_TEST(SphereShaderTest, HalfAndPlainAndDark) {
  Dut<TypeParam> d;
  d.base(31, 20, 8);
  d.op(ShadeHalf);
  d.op(ShadeAdd);
  EXPECT_EQ(d.word(), word_of(0, 495 >> 5, 319 >> 5, 127 >> 5));
  d.op(ShadeStart);
  d.op(ShadePlain);
  d.op(ShadeAdd);
  EXPECT_EQ(d.word(), word_of(0, 991 >> 5, 639 >> 5, 255 >> 5));
  d.op(ShadeStart);
  d.set("dark_i", 1);
  d.op(ShadePlain);
  d.op(ShadeAdd);
  EXPECT_EQ(d.word(), word_of(0, 247 >> 5, 159 >> 5, 63 >> 5));
}

TYPED_TEST(SphereShaderTest, LightIsMarkedIfTheCentreMeetsItDirectly) {
  Dut<TypeParam> d;
  d.op(ShadeLight);
  d.op(ShadeAdd);
  EXPECT_EQ(d.word(), 0xffffu);
  d.op(ShadeStart);
  EXPECT_EQ(d.word(), 0u);
  d.set("direct_i", 0);
  d.op(ShadeLight);
  d.op(ShadeAdd);
  EXPECT_EQ(d.word(), 0x7fffu) << "in a mirror";
  d.op(ShadeStart);
  d.set("direct_i", 1);
  d.set("alias_i", 2);
  d.set("sub_i", 1);
  d.op(ShadeLight);
  EXPECT_EQ(d.word() >> 15, 0u) << "beside the centre";
}

TYPED_TEST(SphereShaderTest, WeightsAreMultipliedAndSaturate) {
  Dut<TypeParam> d;
  d.set("reflect_i", 0x800);
  EXPECT_EQ(d.weight(), 0xfffu * 0x800 >> 12);
  d.base(31, 8, 0);
  d.set("fraction_i", 0xfff);
  d.op(ShadeLit);  // 1487, 383, 0
  d.op(ShadeAdd);
  EXPECT_EQ(d.weight(), 0x7ffu * 0x800 >> 12);
  d.op(ShadeAdd);
  EXPECT_EQ(d.word(), word_of(0, 31, (382 + (383 * 0x7ff >> 12)) >> 5, 0));
}

TYPED_TEST(SphereShaderTest, EightTimesMixesNineWeightedColours) {
  Dut<TypeParam> d;
  d.set("alias_i", 2);
  int sums[3] = {};
  for (unsigned sub = 0; sub < 9; ++sub) {
    d.set("sub_i", sub);
    d.base(sub * 3, 31 - sub, 7);
    d.op(ShadePlain);
    d.op(ShadeAdd);
    const int shift = sub == 0 ? 2 : sub < 5 ? 4 : 3;
    const int base[3] = {static_cast<int>(sub * 3), static_cast<int>(31 - sub), 7};
    for (int c = 0; c < 3; ++c) sums[c] += ((base[c] << 5) * 0xfff >> 12) >> shift;
    EXPECT_EQ(d.word(), word_of(0, sums[0] >> 5, sums[1] >> 5, sums[2] >> 5)) << sub;
    d.op(ShadeStore);
  }
}

TYPED_TEST(SphereShaderTest, FourTimesGivesHalfToTheCentre) {
  Dut<TypeParam> d;
  d.set("alias_i", 1);
  d.op(ShadeLight);
  for (unsigned sub = 0; sub < 5; ++sub) {
    d.set("sub_i", sub);
    d.base(16, 16, 16);
    d.op(ShadePlain);
    d.op(ShadeAdd);
    if (sub < 4) d.op(ShadeStore);
  }
  EXPECT_EQ(d.word(), word_of(1, 511 >> 5, 511 >> 5, 511 >> 5) | 0u)
      << "511 / 2 + 4 * (511 / 8) = 507";
  d.op(ShadeStore);
  d.set("sub_i", 0);
  EXPECT_EQ(d.word(), 0u) << "a new pixel, without light";
}

template <class Unit>
void expect_colour_bits(int bits) {
  sphere_knobs k;
  k.colour_bits = bits;
  Dut<Unit> d(k);
  d.base(31, 21, 10);
  d.op(ShadeLight);
  d.op(ShadeStart);
  d.op(ShadePlain);
  d.op(ShadeAdd);
  const unsigned channels[3] = {991, (21 << 5) * 0xfff >> 12, (10 << 5) * 0xfff >> 12};
  unsigned word = 0;
  for (const unsigned c : channels) word = word << bits | c >> (10 - bits);
  EXPECT_EQ(d.word(), word);
}
TYPED_TEST(SphereShaderTest, StoreOfFourBitsAChannel) { expect_colour_bits<TypeParam>(4); }
TYPED_TEST(SphereShaderTest, StoreOfEightBitsAChannel) { expect_colour_bits<TypeParam>(8); }

TYPED_TEST(SphereShaderTest, ResetForgetsAll) {
  Dut<TypeParam> d;
  d.op(ShadeLight);
  d.op(ShadeAdd);
  d.set("rst_ni", 0);
  d.bench.clock();
  EXPECT_EQ(d.word(), 0u);
  d.set("reflect_i", 0xfff);
  EXPECT_EQ(d.weight(), 0xfffu * 0xfff >> 12);
}

}  // namespace
}  // namespace racebeam
