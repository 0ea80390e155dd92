// Promises of sc/block/numbers.h: products, and the host's floats. Roots and the design's
// vectors: block_root_test, block_normalise_test.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sc/block/numbers.h"

namespace racebeam {
namespace {

constexpr int One = 1 << BlockFraction;

TEST(BlockNumbers, FloatsAreWithinHalfAStepAndTiesGoToEven) {
  std::mt19937 random(1);
  for (int n = 0; n < 100000; ++n) {
    const float value = static_cast<float>(random()) * 0x1p-23f - 256;
    const double steps = double{value} * 16384;
    EXPECT_EQ(f2i(value), static_cast<int>(std::nearbyint(steps)) * 64) << value;
  }
  EXPECT_EQ(f2i(0.5f / 16384), 0);
  EXPECT_EQ(f2i(1.5f / 16384), 2 * 64);
}

TEST(BlockNumbers, ProductsAreRoundedDownAndASumOfThemOnce) {
  EXPECT_EQ(imul(1, -1), -1);
  EXPECT_EQ(imul(-3 * One, One / 2), -3 * One / 2);
  EXPECT_EQ(imul(2047 * One, 2 * One), -2 * One) << "modulo 2^32";
  const vec3 half{1 << 19, 1 << 19, 1 << 19}, odd{1, 1, 1};
  EXPECT_EQ(idot(half, odd), 1) << "three halves";
  EXPECT_EQ(imul(half[0], odd[0]) * 3, 0);
  constexpr int Least = -2147483647 - 1;
  EXPECT_EQ(idot({Least, Least, Least}, {Least, Least, Least}), 0)
      << "3 * 2^62 is 0 in bits 51..20";
}

}  // namespace
}  // namespace racebeam
