// Promises of sc/beam/decision_datapath.h: the decision of one pixel, contract
// sections 5.4, 11.3, 20.3.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "tests/beam/decision_datapath_bench.h"

namespace racebeam {
namespace {

template <class Unit>
using DecisionDatapathDecisionTest = DecisionDatapathTest<Unit>;
TYPED_TEST_SUITE(DecisionDatapathDecisionTest, Twins);

// 11.3, the two examples.
TYPED_TEST(DecisionDatapathDecisionTest, ExampleRayDecides0AtLevel6And1AtLevel7) {
  auto& d = this->dut;
  d.start({0, -224, -1}, room_of(4, 0, 0));
  d.bench.drive("dr1", "_i", {-319, -239, 95});
  d.settle();
  EXPECT_EQ(d.get("dec_o") >> 1, 3) << "signs z 0, y 1, x 1";
  d.descend(3, false);
  EXPECT_EQ(d.get("dec_o"), 6);
  d.descend(3, false);
  EXPECT_EQ(d.get("dec_o"), 7);
}

TYPED_TEST(DecisionDatapathDecisionTest, LeftDecidesWithDr1AndAllOtherStatesWithDr2) {
  auto& d = this->dut;
  d.start({0, 0, 0}, 4);
  d.bench.drive("dr1", "_i", {-1, 5, 5});
  d.bench.drive("dr2", "_i", {5, 5, -1});
  for (const int state : {StateLeft, StateRight, StateBisect, StateReturn}) {
    d.set("state_i", state);
    d.bench.settle();
    EXPECT_EQ(d.get("dec_o") >> 1, state == StateLeft ? 1 : 4);
  }
}

// 20.3: each T(x, m) is weighed against another product of the same value, both ways round.
TYPED_TEST(DecisionDatapathDecisionTest, TruncatedProductsAreThoseOfTheVectors) {
  auto& d = this->dut;
  const int vectors[][3] = {{128, 95, 380},   {127, 318, 1259}, {64, 238, 476},
                            {240, 318, 2385}, {127, 64, 254},   {255, 511, 4068}};
  for (const auto& [x, m, value] : vectors) {
    ASSERT_EQ(product(x, m), value) << "the reference";
    const int near = value == 4068 ? 16 : 1;  // the largest product there is
    int weighed = 0;
    for (int y = 255; y > 0; --y)
      for (int n = 511; n > 0; --n) {
        const int other = product(y, n);
        if (std::abs(other - value) > near || (y == x && n == m) || weighed > 60) continue;
        ++weighed;
        EXPECT_EQ(d.root_bit({x, y, 0}, {n, m, 0}), value >= other) << x << '*' << m;
        EXPECT_EQ(d.root_bit({y, x, 0}, {m, n, 0}), other >= value) << x << '*' << m;
      }
    EXPECT_GT(weighed, 2);
  }
}

TYPED_TEST(DecisionDatapathDecisionTest, NegativeRaysHaveOnesComplementMagnitude) {
  auto& d = this->dut;
  EXPECT_TRUE(d.root_bit({32, 32, 0}, {-100, 99, 0})) << "99 >= 99";
  EXPECT_FALSE(d.root_bit({32, 32, 0}, {-101, 99, 0})) << "99 >= 100";
  EXPECT_TRUE(d.root_bit({32, 32, 0}, {-1, 0, 0})) << "0 >= 0";
  EXPECT_TRUE(d.root_bit({32, 32, 0}, {511, -512, 0})) << "511 >= 511";
}

TYPED_TEST(DecisionDatapathDecisionTest, NegativeCornersDecideByThemselves) {
  auto& d = this->dut;
  const vec3 level{256, 256, 0};
  EXPECT_TRUE(d.root_bit({0, 0, 0}, level)) << "0 is positive: 0 >= 0";
  EXPECT_FALSE(d.root_bit({0, 100, 0}, level));
  EXPECT_TRUE(d.root_bit({100, 0, 0}, level));
  EXPECT_FALSE(d.root_bit({-1, 0, 0}, level)) << "a negative";
  EXPECT_TRUE(d.root_bit({0, -1, 0}, level)) << "b negative";
  EXPECT_TRUE(d.root_bit({-2048, -1, 0}, level)) << "both: b decides";
}

TYPED_TEST(DecisionDatapathDecisionTest, FactorsAreNormalisedTo8Bits) {
  auto& d = this->dut;
  std::mt19937 random(113);
  const auto upto = [&](int n) { return static_cast<int>(random() % n); };
  for (int n = 0; n < 3000; ++n) {
    const vec3 c{upto(1 << (1 + upto(11))), upto(1 << (1 + upto(11))), 0};
    const vec3 dr{upto(1024) - 512, upto(1024) - 512, 0};
    ASSERT_EQ(d.root_bit(c, dr), ge(2, c, dr)) << c[0] << ',' << c[1] << " " << dr[0];
  }
}

template <class Unit>
class DecisionDatapathDecisionKnobs : public testing::Test {};
TYPED_TEST_SUITE(DecisionDatapathDecisionKnobs, Twins);

TYPED_TEST(DecisionDatapathDecisionKnobs, WideFactorsAndNoCutGiveTheSignOfTheExactProduct) {
  knobs k;
  k.corner_factor_bits = 12;
  k.partial_products_cut = 0;
  Dut<TypeParam> d(k);
  std::mt19937 random(303);
  const auto upto = [&](int n) { return static_cast<int>(random() % n); };
  int differs = 0;
  for (int n = 0; n < 4000; ++n) {
    const vec3 c{upto(2048), upto(2048), 0};
    vec3 dr{upto(512), 0, 0};
    dr[1] = c[0] ? std::min(511, c[1] * dr[0] / c[0] + upto(2)) : upto(512);  // close calls
    const bool exact = c[0] * dr[1] >= c[1] * dr[0];
    ASSERT_EQ(d.root_bit(c, dr), exact) << c[0] << ',' << c[1] << ' ' << dr[0] << ',' << dr[1];
    differs += exact != ge(2, c, dr);
  }
  EXPECT_GT(differs, 100) << "and the chip's would often differ";
}

// Without a cut the answer is that of the factors' products; rounding, saturated, changes factors.
TYPED_TEST(DecisionDatapathDecisionKnobs, FactorsAreRoundedWhereTheyAreShifted) {
  knobs k;
  k.corner_rounding = 1;
  k.partial_products_cut = 0;
  Dut<TypeParam> d(k);
  std::mt19937 random(404);
  const auto upto = [&](int n) { return static_cast<int>(random() % n); };
  int differs = 0;
  for (int n = 0; n < 4000; ++n) {
    const vec3 c{upto(1 << (1 + upto(11))), upto(1 << (1 + upto(11))), 0};
    vec3 dr{upto(512), 0, 0};
    dr[1] = c[0] ? std::min(511, c[1] * dr[0] / c[0] + upto(2)) : upto(512);  // close calls
    int scale = 1;
    while (std::max(c[0], c[1]) / scale > 255) scale *= 2;
    const auto factor = [scale](int x) { return std::min(255, (2 * x + scale) / (2 * scale)); };
    const bool rounded = factor(c[0]) * dr[1] >= factor(c[1]) * dr[0];
    ASSERT_EQ(d.root_bit(c, dr), rounded) << c[0] << ',' << c[1] << ' ' << dr[0] << ',' << dr[1];
    differs += rounded != (c[0] / scale * dr[1] >= c[1] / scale * dr[0]);
  }
  EXPECT_GT(differs, 50) << "and without rounding it would often differ";
}

}  // namespace
}  // namespace racebeam
