// Promises of tb/base/expression.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/expression.h"

#include <gmock/gmock.h>

#include "tb/base/errors.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

double x = 0, mode = 0;

Expression expression(const std::string& text) {
  static const std::vector<std::string> words = {"slow", "fast"};
  return {"--if",
          text,
          {"number", "way", "x > 3",
           [](const std::string& name) {
             if (name != "x" && name != "mode") throw UsageError("no number " + name);
             return name == "x" ? &x : &mode;
           },
           [](const std::string& name) { return name == "mode" ? &words : nullptr; }}};
}

std::string refusal(const std::string& text) {
  try {
    expression(text);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

bool holds(const std::string& text, double value) {
  x = value;
  return expression(text).holds();
}

TEST(ExpressionTest, FollowsItsNumbers) {
  Expression both = expression("x > 3 && mode == fast");
  for (int i = 0; i < 8; ++i) {
    x = i;
    mode = i % 2;
    EXPECT_EQ(both.holds(), i > 3 && i % 2) << i;
  }
}

TEST(ExpressionTest, BitsAreThoseOfTwosComplement) {
  for (int value = -9; value < 9; ++value)
    for (int bit = 0; bit < 5; ++bit)
      EXPECT_EQ(holds("bit(x, " + std::to_string(bit) + ")", value), (value >> bit & 1) != 0)
          << value << ", " << bit;
  EXPECT_TRUE(holds("bit(x, 52)", 0x1p52));
  EXPECT_FALSE(holds("bit(x, 200)", 3)) << "there are none";
}

TEST(ExpressionTest, WhatIsDividedByNothingDoesNotHold) {
  EXPECT_FALSE(holds("1 / x", 0));
  EXPECT_TRUE(holds("1 / x", -1));
}

TEST(ExpressionTest, HexadecimalNumbersHaveDigits) {
  EXPECT_TRUE(holds("x == 0x1f", 31));
  EXPECT_NE(refusal("x == 0x"), "");
  EXPECT_NE(refusal("x == 0xg"), "");
}

TEST(ExpressionTest, RefusalsBeginWithTheAskerAndTheText) {
  EXPECT_THAT(refusal("x = 3"), HasSubstr("--if 'x = 3': '=' at character 3; to compare"));
  EXPECT_THAT(refusal("mode == quick"),
              HasSubstr("--if 'mode == quick': mode has no way 'quick' (there is: slow, fast)"));
  EXPECT_EQ(refusal("3"), "--if '3' names no number; try 'x > 3'");
  EXPECT_EQ(refusal("x, x"), "--if 'x, x' is several conditions; join them with && or ||");
  EXPECT_EQ(refusal("y > 3"), "no number y");
  EXPECT_EQ(refusal(std::string(1001, 'x')), "--if has 1001 characters; it may have 1000");
  EXPECT_THAT(refusal(""), HasSubstr("--if ''"));
}

}  // namespace
}  // namespace racebeam
