// Promises of sc/store/write_buffer.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/store/write_buffer.h"

#include <gtest/gtest.h>

#include <deque>
#include <optional>
#include <random>
#include <utility>

#include "tb/twin/unit_bench.h"
#include "tests/store/store_twins.h"

namespace racebeam {
namespace {

using Word = std::pair<std::uint64_t, std::uint64_t>;  // address, data

template <class Unit>
class WriteBufferTest : public testing::Test {
 protected:
  void build(const store_knobs& k) {
    unit.emplace("dut", k);
    bench.emplace(*unit);
    bench->clock();
    pin("rst_ni").drive(1);
    drive(std::nullopt, false);
  }
  UnitBench::Pin& pin(const char* name) { return (*bench)[name]; }
  void drive(const std::optional<Word>& put, bool take) {
    pin("put_valid_i").drive(put.has_value());
    if (put) {
      pin("put_address_i").drive(put->first);
      pin("put_data_i").drive(put->second);
    }
    pin("take_ready_i").drive(take);
    bench->settle();
  }
  /// One clock; returns whether the word was accepted in it.
  bool clock(const std::optional<Word>& put, bool take = false) {
    drive(put, take);
    const bool accepted = put && pin("put_ready_o").value();
    bench->clock();
    return accepted;
  }
  /// The word on offer.
  std::optional<Word> offer() {
    if (!pin("take_valid_o").value()) return std::nullopt;
    return Word{pin("take_address_o").value(), pin("take_data_o").value()};
  }
  unsigned fill() { return static_cast<unsigned>(pin("fill_o").value()); }

  /// Random traffic against a plain queue.
  void agrees_with_a_queue(const store_knobs& k) {
    build(k);
    const unsigned seed = 31 + k.write_buffer_depth;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::deque<Word> queue;
    const std::size_t depth = k.write_buffer_depth;
    std::size_t lost = 0, fullest = 0;
    for (int n = 0; n < 20'000; ++n) {
      const unsigned busy = n / 500 % 5;  // from "hardly taken" to "always taken"
      const Word word{random() & low_bits(k.address_bits()), raw_bits(random(), k.data_bits())};
      const bool put = random() % 5 != 0, take = random() % 5 <= busy;
      drive(put ? std::optional(word) : std::nullopt, take);
      ASSERT_EQ(fill(), queue.size()) << "clock " << n;
      ASSERT_EQ(offer(), queue.empty() ? std::nullopt : std::optional(queue.front()))
          << "clock " << n;
      const bool full = queue.size() == depth;
      const bool ready = k.when_full == WhenFullDrop || !full || take;
      ASSERT_EQ(pin("put_ready_o").value(), ready) << "clock " << n;
      bench->clock();
      if (take && !queue.empty()) queue.pop_front();
      if (!put || !ready) continue;
      if (queue.size() == depth) {
        lost += depth;
        queue.clear();
      }
      queue.push_back(word);
      fullest = std::max(fullest, queue.size());
    }
    EXPECT_EQ(fullest, depth) << "the traffic fills it";
    EXPECT_EQ(lost > 0, k.when_full == WhenFullDrop);
  }

  std::optional<Unit> unit;
  std::optional<UnitBench> bench;
};

using Twins = testing::Types<write_buffer, own_store_rtl<write_buffer>>;
TYPED_TEST_SUITE(WriteBufferTest, Twins);

TYPED_TEST(WriteBufferTest, WordPutIsOnOfferInTheNextClock) {
  this->build({});
  this->drive(Word{5, 77}, true);
  EXPECT_EQ(this->offer(), std::nullopt) << "not in the same clock";
  this->bench->clock();
  EXPECT_EQ(this->offer(), Word(5, 77));
  EXPECT_EQ(this->fill(), 1u);
}

TYPED_TEST(WriteBufferTest, OfferHoldsUntilItIsTaken) {
  this->build({});
  this->clock(Word{5, 77});
  for (int n = 0; n < 5; ++n) {
    this->clock(Word{6, 78 + n});
    EXPECT_EQ(this->offer(), Word(5, 77));
  }
  this->clock(std::nullopt, true);
  EXPECT_EQ(this->offer(), Word(6, 78));
}

TYPED_TEST(WriteBufferTest, HoldsAsManyWordsAsItIsDeepAndGivesTheOldestFirst) {
  this->build({});
  for (unsigned n = 0; n < 64; ++n) EXPECT_TRUE(this->clock(Word{n, 3 * n})) << n;
  EXPECT_EQ(this->fill(), 64u);
  for (unsigned n = 0; n < 64; ++n) {
    EXPECT_EQ(this->offer(), Word(n, 3 * n));
    this->clock(std::nullopt, true);
  }
  EXPECT_EQ(this->offer(), std::nullopt);
  EXPECT_EQ(this->fill(), 0u);
}

TYPED_TEST(WriteBufferTest, WordHeldWhileFullIsNotLost) {
  this->build(entries(4));
  for (unsigned n = 0; n < 4; ++n) this->clock(Word{n, n});
  for (int n = 0; n < 9; ++n) EXPECT_FALSE(this->clock(Word{4, 4}));
  EXPECT_TRUE(this->clock(Word{4, 4}, true)) << "in the clock in which another is taken";
  EXPECT_EQ(this->fill(), 4u);
  for (unsigned n = 1; n <= 4; ++n) {
    EXPECT_EQ(this->offer(), Word(n, n));
    this->clock(std::nullopt, true);
  }
}

TYPED_TEST(WriteBufferTest, DroppingAWordThatFindsItFullStaysAlone) {
  this->build(entries(4, WhenFullDrop));
  for (unsigned n = 0; n < 4; ++n) this->clock(Word{n, n});
  EXPECT_EQ(this->fill(), 4u) << "as many fit";
  EXPECT_TRUE(this->clock(Word{9, 9}));
  EXPECT_EQ(this->fill(), 1u);
  EXPECT_EQ(this->offer(), Word(9, 9));
}

TYPED_TEST(WriteBufferTest, DroppingLosesNothingInAClockThatTakes) {
  this->build(entries(4, WhenFullDrop));
  for (unsigned n = 0; n < 4; ++n) this->clock(Word{n, n});
  EXPECT_TRUE(this->clock(Word{9, 9}, true));
  EXPECT_EQ(this->fill(), 4u);
  EXPECT_EQ(this->offer(), Word(1, 1));
}

TYPED_TEST(WriteBufferTest, ResetEmptiesItAndTakesNothingIn) {
  this->build({});
  for (unsigned n = 0; n < 9; ++n) this->clock(Word{n, n});
  this->pin("rst_ni").drive(0);
  this->clock(Word{7, 7});
  this->pin("rst_ni").drive(1);
  this->bench->settle();
  EXPECT_EQ(this->fill(), 0u);
  EXPECT_EQ(this->offer(), std::nullopt);
}

TYPED_TEST(WriteBufferTest, KeepsTheBitsThatTheFormatHas) {
  this->build(planar());
  for (int bit = 0; bit < StoreDataBits; ++bit) {
    const Word word{1u << bit % StoreAddressBits, std::uint64_t{1} << bit};
    this->clock(word, true);
    EXPECT_EQ(this->offer(), word);
  }
}

TYPED_TEST(WriteBufferTest, BitsBeyondTheFormatAreNotKept) {
  this->build({});
  this->clock(Word{0xfffff, ~std::uint64_t{0}});
  EXPECT_EQ(this->offer(), Word(0x3ffff, 0xffff));
}

TYPED_TEST(WriteBufferTest, OneEntryIsAQueue) { this->agrees_with_a_queue(entries(1)); }
TYPED_TEST(WriteBufferTest, FourEntriesAreAQueue) { this->agrees_with_a_queue(entries(4)); }
TYPED_TEST(WriteBufferTest, NotAPowerOfTwoIsAQueue) { this->agrees_with_a_queue(rgb888()); }
TYPED_TEST(WriteBufferTest, SixtyFourEntriesAreAQueue) { this->agrees_with_a_queue(planar()); }
TYPED_TEST(WriteBufferTest, FourEntriesThatDropAreAQueueThatLoses) {
  this->agrees_with_a_queue(entries(4, WhenFullDrop));
}
TYPED_TEST(WriteBufferTest, The128EntriesThatDropAreAQueueThatLoses) {
  this->agrees_with_a_queue(narrow_planar());
}

}  // namespace
}  // namespace racebeam
