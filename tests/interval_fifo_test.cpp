// Promises of sc/interval_fifo.h: contract section 14.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/interval_fifo.h"

#include <gtest/gtest.h>

#include <deque>
#include <random>
#include <vector>

#include "tb/unit_bench.h"

namespace racebeam {
namespace {

constexpr int Entries = 10;

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;

  explicit Dut(const knobs& k = {}) : unit("dut", k), bench(unit) { reset(); }

  void reset() {
    drive(0, 0, 0, 0);
    bench["tracer_reset_i"].drive(1);
    bench.clock();
    bench["tracer_reset_i"].drive(0);
    bench.settle();
  }
  void drive(int consume, int emit, int pixels, int value) {
    bench["consume_i"].drive(consume);
    bench["emit_i"].drive(emit);
    bench["len_m1_i"].drive(pixels - 1);
    bench["value_i"].drive(value);
    bench.settle();
  }
  /// One clock; returns whether the offer was accepted in it.
  bool clock(int consume, int emit = 0, int pixels = 1, int value = 0) {
    drive(consume, emit, pixels, value);
    const bool ack = this->ack();
    bench.clock();
    return ack;
  }
  bool offer(int pixels, int value) { return clock(0, 1, pixels, value); }
  /// Fills all entries but the head with single pixels; the head holds `head` pixels of index 1.
  void fill_up(int entries, int head = 1) {
    for (int n = 1; n < entries - 1; ++n) offer(1, n % 2 ? 3 : 2);
    offer(head, 1);
  }
  bool ack() { return bench["ack_o"].value(); }
  bool starving() { return bench["starving_o"].value(); }
  int display() { return bench["display_o"].value(); }
  int fill() { return bench["fill_o"].value(); }
};

/// Section 14 said again, in pixels: what each column shows, and the lengths of the entries.
struct Reference {
  int entries = Entries, piece = 64;  // knobs: entries; pixels of a shed entry
  std::vector<int> line{0};           // index by column, as far as accepted
  int column = 0;                     // on show
  int last = 0;                       // index of the youngest entry
  std::deque<int> older;              // pixels left in all entries but the youngest, oldest first
  int youngest = 1;                   // pixels left; may be negative

  bool starving() const { return column >= static_cast<int>(line.size()); }
  int display() const { return starving() ? last : line[column]; }
  int fill() const { return static_cast<int>(older.size()) + 1; }

  bool clock(bool consume, bool emit, int pixels, int value) {
    const bool alone = older.empty(), full = fill() == entries;
    bool ack = false;
    if (alone && consume) {
      --youngest;
    } else if (youngest > piece && !full) {
      older.push_back(piece);
      youngest -= piece;
    } else if (emit) {
      const bool too_long = youngest > 0 && youngest + pixels > 1024;
      if ((value == last || starving()) && !too_long) {
        youngest += pixels;
        ack = true;
      } else if (!full) {
        older.push_back(youngest);
        youngest = pixels;
        ack = true;
      }
    }
    if (!alone && consume && --older.front() == 0) older.pop_front();
    if (ack) {
      line.insert(line.end(), pixels, value);
      last = value;
    }
    column += consume;
    return ack;
  }
};

template <class Unit>
class IntervalFifoTest : public testing::Test {
 protected:
  Dut<Unit> dut;
};

using Twins = testing::Types<interval_fifo>;
TYPED_TEST_SUITE(IntervalFifoTest, Twins);

TYPED_TEST(IntervalFifoTest, StartsWithOnePixelOfIndex0) {
  auto& d = this->dut;
  EXPECT_EQ(d.fill(), 1);
  EXPECT_EQ(d.display(), 0);
  EXPECT_FALSE(d.starving());
  d.clock(1);
  EXPECT_TRUE(d.starving());
}

TYPED_TEST(IntervalFifoTest, AcceptedIntervalIsShownAfterColumn0FromTheNextClockOn) {
  auto& d = this->dut;
  EXPECT_TRUE(d.offer(2, 3));
  EXPECT_EQ(d.display(), 0);
  EXPECT_EQ(d.fill(), 2);
  d.clock(1);
  EXPECT_EQ(d.display(), 3);
  d.clock(1);
  EXPECT_EQ(d.display(), 3);
  EXPECT_FALSE(d.starving());
  d.clock(1);
  EXPECT_TRUE(d.starving());
}

// Trace of frame 2, y = -240: clocks 135, 164, (179), 186..188, 194..197, 253, 274..322.
TYPED_TEST(IntervalFifoTest, TraceOfFrame2FillsTheQueueAndStallsUntilClock322) {
  auto& d = this->dut;
  EXPECT_TRUE(d.offer(1, 3));
  EXPECT_EQ(d.fill(), 2) << "c = 136, tail_ptr 8";
  EXPECT_TRUE(d.offer(16, 2));
  EXPECT_EQ(d.fill(), 3) << "c = 165, tail_ptr 7";
  EXPECT_TRUE(d.offer(11, 3));
  EXPECT_TRUE(d.offer(100, 1));
  EXPECT_EQ(d.fill(), 5) << "c = 187";
  EXPECT_FALSE(d.offer(95, 1)) << "the head splits";
  EXPECT_EQ(d.fill(), 6) << "c = 188, tail_ptr 4";
  EXPECT_TRUE(d.offer(95, 1)) << "merges";
  EXPECT_EQ(d.fill(), 6) << "c = 195, head 131";
  d.clock(0);
  EXPECT_EQ(d.fill(), 7);
  d.clock(0);
  EXPECT_EQ(d.fill(), 8) << "c = 197, head 3, tail_ptr 2";
  d.clock(0);
  EXPECT_EQ(d.fill(), 8);
  EXPECT_TRUE(d.offer(32, 2));
  EXPECT_TRUE(d.offer(20, 3));
  EXPECT_EQ(d.fill(), 10) << "c = 253, tail_ptr 0";
  for (int n = 0; n < 5; ++n) EXPECT_FALSE(d.offer(7, 1)) << "stalled";
  EXPECT_EQ(d.display(), 0) << "c = 320";
  EXPECT_FALSE(d.clock(1, 1, 7, 1)) << "c = 321";
  EXPECT_EQ(d.display(), 3) << "c = 322";
  EXPECT_EQ(d.fill(), 9);
  EXPECT_TRUE(d.offer(7, 1)) << "c = 322";
  // The columns that follow: 1 x 3, 16 x 2, 11 x 3, 195 x 1, 32 x 2, 20 x 3, 7 x 1.
  const int runs[][2] = {{1, 3}, {16, 2}, {11, 3}, {195, 1}, {32, 2}, {20, 3}, {7, 1}};
  for (const auto& run : runs)
    for (int n = 0; n < run[0]; ++n) {
      ASSERT_EQ(d.display(), run[1]) << n << " of " << run[0];
      d.clock(0);
      d.clock(1);
    }
  EXPECT_TRUE(d.starving());
}

// Trace of frame 2, y = -24: clocks 971..1001.
TYPED_TEST(IntervalFifoTest, LateIntervalIsShortenedByTheStarvedColumns) {
  auto& d = this->dut;
  d.offer(1, 2);
  d.clock(1);
  EXPECT_FALSE(d.starving());
  for (int n = 0; n < 15; ++n) {
    d.clock(1);  // c = 971, 973, .. 999: head_len -1 .. -15
    EXPECT_TRUE(d.starving());
    EXPECT_EQ(d.display(), 2) << "the old colour";
    if (n < 14) d.clock(0);
  }
  EXPECT_TRUE(d.offer(27, 0)) << "c = 1000";
  for (int left = 13; left > 0; --left) {  // head_len 12 at c = 1001
    EXPECT_FALSE(d.starving()) << left;
    EXPECT_EQ(d.display(), 0) << left;
    EXPECT_EQ(d.fill(), 1);
    d.clock(1);
  }
  EXPECT_TRUE(d.starving());
}

TYPED_TEST(IntervalFifoTest, IntervalShorterThanTheDebtLeavesTheBeamStarving) {
  auto& d = this->dut;
  for (int n = 0; n < 6; ++n) d.clock(1);
  EXPECT_TRUE(d.offer(5, 3)) << "debt 5";
  EXPECT_TRUE(d.starving());
  EXPECT_EQ(d.display(), 3) << "the colour changes in the middle of a pixel";
  EXPECT_TRUE(d.offer(1, 1));
  EXPECT_FALSE(d.starving());
  EXPECT_EQ(d.display(), 1);
}

TYPED_TEST(IntervalFifoTest, HeadAloneBeingEatenTakesNoOffer) {
  auto& d = this->dut;
  EXPECT_FALSE(d.clock(1, 1, 4, 0)) << "same colour";
  EXPECT_FALSE(d.clock(1, 1, 4, 2)) << "starving";
  EXPECT_TRUE(d.clock(0, 1, 4, 2));
  EXPECT_FALSE(d.starving());
}

TYPED_TEST(IntervalFifoTest, OffersAreTakenWhileAnOlderEntryIsEaten) {
  auto& d = this->dut;
  d.offer(5, 1);
  EXPECT_TRUE(d.clock(1, 1, 3, 1)) << "merges while column 0 ends";
  EXPECT_EQ(d.fill(), 1);
  for (int n = 0; n < 8; ++n) {
    EXPECT_EQ(d.display(), 1);
    EXPECT_FALSE(d.starving());
    d.clock(1);
  }
  EXPECT_TRUE(d.starving());
}

TYPED_TEST(IntervalFifoTest, OwnColourMergesIntoOneEntry) {
  auto& d = this->dut;
  d.offer(1, 2);
  for (int n = 0; n < 63; ++n) EXPECT_TRUE(d.offer(1, 2));
  EXPECT_EQ(d.fill(), 2);
  EXPECT_TRUE(d.offer(1, 3));
  EXPECT_EQ(d.fill(), 3);
}

// head_len >= 64 splits: 64 pixels do not, 65 do.
TYPED_TEST(IntervalFifoTest, HeadOf65PixelsShedsAnEntryOf64) {
  auto& d = this->dut;
  d.offer(64, 2);
  EXPECT_TRUE(d.offer(1, 2)) << "64 pixels stay whole";
  EXPECT_EQ(d.fill(), 2);
  EXPECT_FALSE(d.offer(1, 2)) << "65 pixels split";
  EXPECT_EQ(d.fill(), 3);
  EXPECT_TRUE(d.offer(1, 2));
  d.clock(1);
  for (int n = 0; n < 66; ++n, d.clock(1)) ASSERT_EQ(d.display(), 2) << n;
  EXPECT_TRUE(d.starving());
}

TYPED_TEST(IntervalFifoTest, LoneLongHeadIsNotSplitInAClockThatEatsIt) {
  auto& d = this->dut;
  d.clock(1);
  d.offer(641, 1);  // starving: becomes the head
  EXPECT_EQ(d.fill(), 1);
  d.clock(1);
  EXPECT_EQ(d.fill(), 1) << "eaten";
  d.clock(0);
  EXPECT_EQ(d.fill(), 2) << "split";
  for (int n = 0; n < 640; ++n, d.clock(1)) ASSERT_FALSE(d.starving()) << n;
  EXPECT_TRUE(d.starving());
}

TYPED_TEST(IntervalFifoTest, PushHeldWhileFullIsNotLost) {
  auto& d = this->dut;
  d.fill_up(Entries);
  EXPECT_EQ(d.fill(), Entries);
  for (int n = 0; n < 20; ++n) EXPECT_FALSE(d.offer(5, 2));
  EXPECT_FALSE(d.clock(1, 1, 5, 2)) << "still full in the clock that eats an entry";
  EXPECT_TRUE(d.clock(0, 1, 5, 2)) << "free in the next";
  EXPECT_EQ(d.fill(), Entries);
  for (int n = 1; n < Entries - 1; ++n, d.clock(1)) EXPECT_EQ(d.display(), n % 2 ? 3 : 2);
  EXPECT_EQ(d.display(), 1);
  d.clock(1);
  for (int n = 0; n < 5; ++n, d.clock(1)) EXPECT_EQ(d.display(), 2);
  EXPECT_TRUE(d.starving());
}

TYPED_TEST(IntervalFifoTest, FullQueueStillMergesItsOwnColourUpTo1024Pixels) {
  auto& d = this->dut;
  d.fill_up(Entries, 640);
  EXPECT_TRUE(d.offer(383, 1)) << "full: the long head does not split, and merges";
  EXPECT_FALSE(d.offer(2, 1)) << "1025 pixels do not fit";
  EXPECT_TRUE(d.offer(1, 1)) << "1024 do";
  EXPECT_FALSE(d.offer(1, 1)) << "held";
  EXPECT_EQ(d.fill(), Entries);
}

TYPED_TEST(IntervalFifoTest, OwnColourThatWouldOverflowTheHeadBecomesAnEntry) {
  auto& d = this->dut;
  d.offer(20, 2);
  EXPECT_TRUE(d.offer(1005, 2));
  EXPECT_EQ(d.fill(), 3) << "not merged";
  d.reset();
  d.offer(20, 2);
  EXPECT_TRUE(d.offer(1004, 2));
  EXPECT_EQ(d.fill(), 2) << "merged to 1024";
  d.reset();
  EXPECT_TRUE(d.offer(1024, 0));
  EXPECT_EQ(d.fill(), 2) << "not merged with column 0";
}

TYPED_TEST(IntervalFifoTest, AckNeedsAnOffer) {
  auto& d = this->dut;
  d.drive(0, 0, 5, 0);
  EXPECT_FALSE(d.ack());
  d.drive(0, 1, 5, 0);
  EXPECT_TRUE(d.ack()) << "in the same clock";
  d.drive(1, 1, 5, 0);
  EXPECT_FALSE(d.ack()) << "follows consume too";
}

TYPED_TEST(IntervalFifoTest, ResetDropsEverything) {
  auto& d = this->dut;
  d.fill_up(Entries, 300);
  for (int n = 0; n < 4; ++n) d.clock(1);
  d.bench["tracer_reset_i"].drive(1);
  d.clock(1, 1, 200, 3);
  d.bench["tracer_reset_i"].drive(0);
  d.clock(0);
  EXPECT_EQ(d.fill(), 1);
  EXPECT_EQ(d.display(), 0);
  EXPECT_FALSE(d.starving());
  d.clock(1);
  EXPECT_TRUE(d.starving());
}

// Whole lines with random intervals, held until accepted, and a beam that comes and goes.
template <class Unit>
void expect_pixels_of_reference(Dut<Unit>& d, unsigned seed, int lines, int entries, int piece) {
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  const auto upto = [&](int n) { return static_cast<int>(random() % n); };
  for (int line = 0; line < lines; ++line) {
    Reference r;
    r.entries = entries;
    r.piece = piece;
    d.reset();
    const int beam = 1 + upto(4), tracer = 1 + upto(40), longest = 1 << upto(11);
    int given = 0, pixels = 0, value = 0;
    for (int c = 0; r.column < 700; ++c) {
      const bool consume = upto(beam) == 0;
      if (!pixels && given < 640 && upto(tracer) == 0) {
        pixels = 1 + upto(longest);
        value = upto(4);
      } else if (pixels && upto(8) == 0) {
        value = r.starving() ? 0 : value;  // the colour may change while an offer waits
      }
      ASSERT_EQ(d.display(), r.display()) << "line " << line << " column " << r.column;
      ASSERT_EQ(d.starving(), r.starving()) << "line " << line << " column " << r.column;
      ASSERT_EQ(d.fill(), r.fill()) << "line " << line << " column " << r.column;
      const bool expected = r.clock(consume, pixels, pixels, value);
      ASSERT_EQ(d.clock(consume, pixels > 0, pixels, value), expected)
          << "line " << line << " column " << r.column << " clock " << c;
      if (expected) given += pixels, pixels = 0;
    }
  }
}

TYPED_TEST(IntervalFifoTest, RandomLinesShowThePixelsOfThePlainList) {
  expect_pixels_of_reference(this->dut, 14, 60, Entries, 64);
}

void expect_knobs(int entries, int bits) {
  knobs k;
  k.fifo_entries = entries;
  k.fifo_short_length_bits = bits;
  Dut<interval_fifo> d(k);
  expect_pixels_of_reference(d, 100 * entries + bits, 30, entries, 1 << bits);
}

TEST(IntervalFifoKnobs, QueueOf3EntriesKeepsThePromises) { expect_knobs(3, 6); }
TEST(IntervalFifoKnobs, QueueOf64EntriesKeepsThePromises) { expect_knobs(64, 6); }
TEST(IntervalFifoKnobs, EntriesOf8PixelsKeepThePromises) { expect_knobs(10, 3); }
TEST(IntervalFifoKnobs, EntriesOf1024PixelsKeepThePromises) { expect_knobs(10, 10); }
TEST(IntervalFifoKnobs, SmallestQueueKeepsThePromises) { expect_knobs(3, 3); }

TEST(IntervalFifoKnobs, QueueOf3EntriesIsFullWith3) {
  knobs k;
  k.fifo_entries = 3;
  Dut<interval_fifo> d(k);
  EXPECT_TRUE(d.offer(1, 1));
  EXPECT_TRUE(d.offer(1, 2));
  EXPECT_EQ(d.fill(), 3);
  EXPECT_FALSE(d.offer(1, 3));
  EXPECT_FALSE(d.clock(1, 1, 1, 3));
  EXPECT_TRUE(d.offer(1, 3));
}

}  // namespace
}  // namespace racebeam
