// Promises of sc/beam/stacks.h: contract section 10.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/stacks.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>
#include <vector>

#include "tb/twin/unit_bench.h"
#include "tests/support/own_rtl.h"

namespace racebeam {
namespace {

using Entry = std::pair<int, int>;  // tag, i2

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;

  explicit Dut(const knobs& k = {}) : unit("dut", k), bench(unit) {}

  void push(int sp, const Entry& e) {
    bench["push_en_i"].drive(1);
    bench["sp_i"].drive(sp);
    bench["tag_i"].drive(e.first);
    bench["i2_i"].drive(e.second);
    bench.clock();
    bench["push_en_i"].drive(0);
  }
  Entry top(int sp) {
    bench["sp_i"].drive(sp);
    bench.settle();
    return {bench["top_tag_o"].value(), bench["top_i2_o"].value()};
  }
  /// Faces are addressed by the depth, the upper bits of the tag.
  void write_face(int depth, int face) {
    bench["fwrite_i"].drive(1);
    bench["fdata_i"].drive(face);
    bench["tag_i"].drive(depth << LevelBits | 7);
    bench.clock();
    bench["fwrite_i"].drive(0);
  }
  int face(int depth, int level = 0) {
    bench["tag_i"].drive(depth << LevelBits | level);
    bench.settle();
    return bench["fread_o"].value();
  }
};

template <class Unit>
class StacksTest : public testing::Test {
 protected:
  Dut<Unit> dut;
};

using Twins = testing::Types<stacks, own_rtl<stacks>>;
TYPED_TEST_SUITE(StacksTest, Twins);

// Item S of section 18: never reset, 0 at power-up.
TYPED_TEST(StacksTest, PowersUpWithZeroes) {
  for (int sp = 0; sp < 4; ++sp) EXPECT_EQ(this->dut.top(sp), Entry(0, 0));
  for (int depth = 0; depth < 16; ++depth) EXPECT_EQ(this->dut.face(depth), 0);
}

// 10.1: a push writes at sp, the top is the word at (sp - 1) mod 4.
TYPED_TEST(StacksTest, TopIsTheWordBelowTheStackPointer) {
  auto& d = this->dut;
  const Entry words[] = {{2, 639}, {6, 318}, {7, 254}, {14, 222}};
  for (int sp = 0; sp < 4; ++sp) d.push(sp, words[sp]);
  for (int sp = 0; sp < 4; ++sp) EXPECT_EQ(d.top(sp), words[(sp + 3) % 4]) << "sp " << sp;
}

// 10.1: the trace of 9.9 pushes {1.7, 127} over {0.2, 639}; pops then give the 4 youngest words.
TYPED_TEST(StacksTest, FifthPushOverwritesTheOldestWord) {
  auto& d = this->dut;
  const Entry pushed[] = {{2, 639}, {6, 318}, {7, 254}, {14, 222}, {15, 127}};
  for (int n = 0; n < 5; ++n) d.push(n % 4, pushed[n]);
  int sp = 5 % 4;
  for (const int n : {4, 3, 2, 1, 4}) {
    EXPECT_EQ(d.top(sp), pushed[n]);
    sp = (sp + 3) % 4;
  }
}

TYPED_TEST(StacksTest, WordsKeepAllTheirBits) {
  auto& d = this->dut;
  for (int bit = 0; bit < 17; ++bit) {
    const Entry word{1 << bit >> 10, (1 << bit) & 1023};
    d.push(2, word);
    EXPECT_EQ(d.top(3), word) << "bit " << bit;
  }
  d.push(2, {127, 1023});
  EXPECT_EQ(d.top(3), Entry(127, 1023));
}

TYPED_TEST(StacksTest, PushIsReadFromTheNextClockOn) {
  auto& d = this->dut;
  d.push(1, {9, 99});
  d.bench["push_en_i"].drive(1);
  d.bench["tag_i"].drive(50);
  d.bench["i2_i"].drive(500);
  d.bench["sp_i"].drive(1);
  EXPECT_EQ(d.top(2), Entry(9, 99)) << "before the edge";
  d.bench["sp_i"].drive(1);
  d.bench.clock();
  EXPECT_EQ(d.top(2), Entry(50, 500));
}

TYPED_TEST(StacksTest, NothingIsWrittenWithoutAnEnable) {
  auto& d = this->dut;
  d.push(0, {5, 55});
  d.write_face(3, 2);
  d.bench["sp_i"].drive(0);
  d.bench["tag_i"].drive(3 << LevelBits);
  d.bench["i2_i"].drive(1);
  d.bench["fdata_i"].drive(1);
  d.bench.clock(3);
  EXPECT_EQ(d.top(1), Entry(5, 55));
  EXPECT_EQ(d.face(4), 2);
}

// 10.2: written at the depth before the room is entered, read at depth - 1; the level is no
// address.
TYPED_TEST(StacksTest, FaceWrittenAtADepthIsReadOneDeeper) {
  auto& d = this->dut;
  const int faces[9] = {3, 0, 1, 2, 3, 2, 1, 0, 3};
  for (int depth = 0; depth < 9; ++depth) d.write_face(depth, faces[depth]);
  for (int depth = 1; depth <= 9; ++depth)
    for (int level = 0; level < 8; ++level) EXPECT_EQ(d.face(depth, level), faces[depth - 1]);
}

// 11.9: reads at depth 0 or above 9 give 0, writes above depth 8 are lost.
TYPED_TEST(StacksTest, FacesBeyondTheStackAreLostAndReadZero) {
  auto& d = this->dut;
  for (int depth = 0; depth < 9; ++depth) d.write_face(depth, 1);
  for (int depth = 9; depth < 16; ++depth) d.write_face(depth, 3);
  EXPECT_EQ(d.face(0), 0);
  for (int depth = 1; depth <= 9; ++depth) EXPECT_EQ(d.face(depth), 1) << depth;
  for (int depth = 10; depth < 16; ++depth) EXPECT_EQ(d.face(depth), 0) << depth;
}

// Both stacks at once against plain maps.
TYPED_TEST(StacksTest, BothStacksRememberUnderRandomTraffic) {
  constexpr unsigned Seed = 10;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  std::mt19937 random(Seed);
  const auto upto = [&](int n) { return static_cast<int>(random() % n); };
  auto& b = this->dut.bench;
  std::map<int, Entry> words;
  std::map<int, int> faces;
  for (int n = 0; n < 20000; ++n) {
    const int push = upto(2), write = upto(2), sp = upto(4), depth = upto(10), level = upto(8);
    const int tag = depth << LevelBits | level, i2 = upto(1024), face = upto(4);
    b["push_en_i"].drive(push);
    b["sp_i"].drive(sp);
    b["tag_i"].drive(tag);
    b["i2_i"].drive(i2);
    b["fwrite_i"].drive(write);
    b["fdata_i"].drive(face);
    b.settle();
    const Entry top{b["top_tag_o"].value(), b["top_i2_o"].value()};
    ASSERT_EQ(top, words[(sp + 3) % 4]) << "clock " << n;
    ASSERT_EQ(b["fread_o"].value(), depth ? faces[depth - 1] : 0) << "clock " << n;
    b.clock();
    if (push) words[sp] = {tag, i2};
    if (write && depth <= 8) faces[depth] = face;
  }
}

template <class Unit>
class StacksKnobs : public testing::Test {};
TYPED_TEST_SUITE(StacksKnobs, Twins);

// Knob interval_stack_depth: a ring of that many words.
template <class Unit>
void expect_ring_of(int size) {
  knobs k;
  k.interval_stack_depth = size;
  Dut<Unit> d(k);
  std::vector<Entry> pushed;
  int sp = 0;
  for (int n = 0; n < 2 * size + 1; ++n) {
    pushed.push_back({n % 128, 639 - n});
    d.push(sp, pushed.back());
    sp = (sp + 1) % size;
    ASSERT_EQ(d.top(sp), pushed.back());
  }
  for (int n = 0; n < size; ++n) {
    EXPECT_EQ(d.top(sp), pushed.back()) << "pop " << n;
    pushed.pop_back();
    sp = (sp + size - 1) % size;
  }
}

TYPED_TEST(StacksKnobs, IntervalStackOfOneWordHoldsTheYoungest) { expect_ring_of<TypeParam>(1); }
TYPED_TEST(StacksKnobs, IntervalStackOfTwoWordsIsARingOfTwo) { expect_ring_of<TypeParam>(2); }
TYPED_TEST(StacksKnobs, IntervalStackOf64WordsIsARingOf64) { expect_ring_of<TypeParam>(64); }

// Knob face_stack_depth: one word for each room entered.
template <class Unit>
void expect_faces_up_to(int size) {
  knobs k;
  k.face_stack_depth = size;
  Dut<Unit> d(k);
  for (int depth = 0; depth < 16; ++depth) d.write_face(depth, 1 + depth % 3);
  for (int depth = 0; depth < 16; ++depth)
    EXPECT_EQ(d.face(depth), depth >= 1 && depth <= size ? 1 + (depth - 1) % 3 : 0) << depth;
}

TYPED_TEST(StacksKnobs, FaceStackOfTwoWordsHoldsTwoFaces) { expect_faces_up_to<TypeParam>(2); }
TYPED_TEST(StacksKnobs, FaceStackOf15WordsHolds15Faces) { expect_faces_up_to<TypeParam>(15); }

}  // namespace
}  // namespace racebeam
