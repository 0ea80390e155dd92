// Promises of sc/block/block_bus.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_bus.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "tb/twin/unit_bench.h"
#include "tests/block/twins.h"

namespace racebeam {
namespace {

constexpr std::uint64_t All = ~std::uint64_t{0};

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;

  explicit Dut(int cores = 4) : unit("dut", with_cores(cores)), bench(unit) {
    bench.clock();
    bench["rst_ni"].drive(1);
    bench["bus_ready_i"].drive(1);
    bench.clock();
  }
  static block_knobs with_cores(int cores) {
    block_knobs k;
    k.cores = cores;
    return k;
  }
  void ask(std::uint64_t cores) {
    bench["word_valid_i"].drive(cores);
    bench.settle();
  }
  std::uint64_t served() { return bench["word_ready_o"].value(); }
  std::uint64_t core() { return bench["core_o"].value(); }
  bool valid() { return bench["bus_valid_o"].value() != 0; }
};

template <class Unit>
class BlockBusTest : public testing::Test {};
TYPED_TEST_SUITE(BlockBusTest, block_twins<block_bus>);

TYPED_TEST(BlockBusTest, NothingAskedNothingServed) {
  Dut<TypeParam> d;
  d.ask(0);
  EXPECT_FALSE(d.valid());
  EXPECT_EQ(d.core(), 0u);
  EXPECT_EQ(d.served(), 0u);
}

TYPED_TEST(BlockBusTest, AllAskingAreServedInTurnWithoutAnIdleClock) {
  Dut<TypeParam> d;
  d.ask(15);
  for (unsigned n = 0; n < 12; ++n) {
    EXPECT_TRUE(d.valid());
    EXPECT_EQ(d.core(), n % 4);
    EXPECT_EQ(d.served(), 1u << n % 4);
    d.bench.clock();
  }
}

TYPED_TEST(BlockBusTest, AloneACoreHasEveryClock) {
  Dut<TypeParam> d;
  d.ask(4);
  for (int n = 0; n < 5; ++n) {
    EXPECT_EQ(d.served(), 4u);
    d.bench.clock();
  }
}

TYPED_TEST(BlockBusTest, WaitingBusServesNobodyAndKeepsTheTurn) {
  Dut<TypeParam> d;
  d.ask(15);
  d.bench.clock();
  d.bench["bus_ready_i"].drive(0);
  d.bench.clock(5);
  EXPECT_TRUE(d.valid());
  EXPECT_EQ(d.served(), 0u);
  EXPECT_EQ(d.core(), 1u);
}

TYPED_TEST(BlockBusTest, CoresThatThereAreNotDoNotCount) {
  Dut<TypeParam> d(3);
  d.ask(All << 3);
  EXPECT_FALSE(d.valid());
  EXPECT_EQ(d.served(), 0u);
}

TYPED_TEST(BlockBusTest, ResetBeginsWithTheLowest) {
  Dut<TypeParam> d;
  d.ask(15);
  d.bench.clock(2);
  d.bench["rst_ni"].drive(0);
  d.bench.clock();
  EXPECT_EQ(d.core(), 0u);
}

/// No core waits for more words than there are others; a core's words all come, one after another.
template <class Unit>
void expect_fair(int cores) {
  constexpr unsigned Seed = 8;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  std::mt19937 random(Seed);
  Dut<Unit> d(cores);
  std::vector<int> words(static_cast<std::size_t>(cores)), waits(words);
  for (int n = 0; n < 3000; ++n) {
    std::uint64_t asked = 0;
    for (std::size_t c = 0; c < words.size(); ++c) {
      if (words[c] == 0 && random() % 8 == 0) words[c] = 3;
      if (words[c] > 0) asked |= std::uint64_t{1} << c;
    }
    const bool ready = random() % 4 != 0;
    d.bench["bus_ready_i"].drive(ready ? 1 : 0);
    d.ask(asked);
    ASSERT_EQ(d.valid(), asked != 0);
    const std::size_t core = d.core();
    ASSERT_EQ(d.served(), asked != 0 && ready ? std::uint64_t{1} << core : 0);
    if (asked != 0 && ready) {
      ASSERT_TRUE(asked >> core & 1);
      for (std::size_t c = 0; c < words.size(); ++c) {
        waits[c] = words[c] > 0 && c != core ? waits[c] + 1 : 0;
        ASSERT_LT(waits[c], cores) << "core " << c;
      }
      --words[core];
    }
    d.bench.clock();
  }
}
TYPED_TEST(BlockBusTest, NoneOfFourWaitsLonger) { expect_fair<TypeParam>(4); }
TYPED_TEST(BlockBusTest, NoneOf64WaitsLonger) { expect_fair<TypeParam>(64); }
TYPED_TEST(BlockBusTest, OneHasAllClocks) { expect_fair<TypeParam>(1); }

}  // namespace
}  // namespace racebeam
