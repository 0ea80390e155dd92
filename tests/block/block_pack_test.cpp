// Promises of sc/block/block_pack.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_pack.h"

#include <gtest/gtest.h>

#include "tb/twin/unit_bench.h"
#include "tests/block/twins.h"

namespace racebeam {
namespace {

template <class Unit>
class BlockPackTest : public testing::Test {
 protected:
  void SetUp() override {
    bench.clock();
    bench["rst_ni"].drive(1);
  }
  void pixel(unsigned n, bool last) {
    bench["valid_i"].drive(1);
    bench["red_i"].drive(n);
    bench["green_i"].drive(0x40 + n);
    bench["blue_i"].drive(0xf0 - n);
    bench.settle();
    EXPECT_EQ(bench["full_o"].value(), last) << n;
    bench.clock();
    bench["valid_i"].drive(0);
  }
  Unit unit{"dut"};
  UnitBench bench{unit};
};
TYPED_TEST_SUITE(BlockPackTest, block_twins<block_pack>);

TYPED_TEST(BlockPackTest, TheFirstOfEightPixelsLiesLowest) {
  for (int word = 0; word < 3; ++word) {
    for (unsigned n = 1; n <= 8; ++n) this->pixel(n, n == 8);
    EXPECT_EQ(this->bench["red_o"].value(), 0x0807060504030201u);
    EXPECT_EQ(this->bench["green_o"].value(), 0x4847464544434241u);
    EXPECT_EQ(this->bench["blue_o"].value(), 0xe8e9eaebecedeeefu);
  }
}

TYPED_TEST(BlockPackTest, WaitsBetweenPixels) {
  for (unsigned n = 1; n <= 7; ++n) this->pixel(n, false);
  this->bench.settle();
  EXPECT_EQ(this->bench["full_o"].value(), 0u);
  this->bench["red_i"].drive(99);
  this->bench.clock(5);
  this->pixel(8, true);
  EXPECT_EQ(this->bench["red_o"].value(), 0x0807060504030201u);
}

TYPED_TEST(BlockPackTest, ResetForgetsTheBegunWord) {
  for (unsigned n = 1; n <= 5; ++n) this->pixel(n, false);
  this->bench["rst_ni"].drive(0);
  this->bench.clock();
  EXPECT_EQ(this->bench["red_o"].value(), 0u);
  this->bench["rst_ni"].drive(1);
  for (unsigned n = 1; n <= 8; ++n) this->pixel(n, n == 8);
}

}  // namespace
}  // namespace racebeam
