// Promises of sc/beam/interval_fifo.h: random lines against a plain list of pixels.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <deque>
#include <random>
#include <vector>

#include "tests/beam/interval_fifo_bench.h"

namespace racebeam {
namespace {

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

template <class Unit>
using IntervalFifoLinesTest = IntervalFifoTest<Unit>;
TYPED_TEST_SUITE(IntervalFifoLinesTest, Twins);

TYPED_TEST(IntervalFifoLinesTest, RandomLinesShowThePixelsOfThePlainList) {
  expect_pixels_of_reference(this->dut, 14, 60, Entries, 64);
}

template <class Unit>
class IntervalFifoLinesKnobs : public testing::Test {};
TYPED_TEST_SUITE(IntervalFifoLinesKnobs, Twins);

template <class Unit>
void expect_knobs(int entries, int bits) {
  knobs k;
  k.fifo_entries = entries;
  k.fifo_short_length_bits = bits;
  Dut<Unit> d(k);
  expect_pixels_of_reference(d, 100 * entries + bits, 30, entries, 1 << bits);
}

TYPED_TEST(IntervalFifoLinesKnobs, QueueOf3EntriesKeepsThePromises) {
  expect_knobs<TypeParam>(3, 6);
}
TYPED_TEST(IntervalFifoLinesKnobs, QueueOf64EntriesKeepsThePromises) {
  expect_knobs<TypeParam>(64, 6);
}
TYPED_TEST(IntervalFifoLinesKnobs, EntriesOf8PixelsKeepThePromises) {
  expect_knobs<TypeParam>(10, 3);
}
TYPED_TEST(IntervalFifoLinesKnobs, EntriesOf1024PixelsKeepThePromises) {
  expect_knobs<TypeParam>(10, 10);
}
TYPED_TEST(IntervalFifoLinesKnobs, SmallestQueueKeepsThePromises) { expect_knobs<TypeParam>(3, 3); }

}  // namespace
}  // namespace racebeam
