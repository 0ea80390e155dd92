// Promises of sc/beam/subdivider.h: clock by clock, contract section 9.9.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tests/beam/subdivider_bench.h"

namespace racebeam {
namespace {

/// What stands around the unit in frame 2, y = -240: tree, rooms and both stacks.
template <class Unit>
struct Frame2 {
  Dut<Unit>& d;
  int c = 50, depth = 0, level = 2;
  bool second = false, wall = false;
  int tags[4]{}, ends[4]{};
  // Last pixel of the left branch, by place; the rooms' walls, by left pixel and place.
  const std::map<int, int> splits{{2, 318}, {6, 254}, {7, 222}, {tag_of(1, 6), 127},
                                  {15, 27}, {22, 0},  {32, 16}};
  const std::set<std::pair<int, int>> walls{
      {0, tag_of(3, 7)}, {17, tag_of(4, 7)}, {28, 15}, {128, 15}, {223, 15}};

  explicit Frame2(Dut<Unit>& d) : d(d) {
    d.start(639, 0);
    settle();
  }
  int tag() const { return tag_of(depth, level); }
  int dec(int pixel) const {
    const auto split = splits.find(tag());
    const bool right = split != splits.end() && pixel > split->second;
    if (tag() == 2) return right ? 4 : 6;  // signs z 0, y 1, x 1 or 0
    if (tag() == 32) return !right;        // 4.0: wall on the left
    return right;
  }
  void settle() {
    const int top = (d.get("sp_o") + 3) % 4;
    d.set("mask_i", tag() == 2 ? SignMask : BitMask);
    d.set("dec_i", dec(d.state() == StateLeft ? d.i1() : d.idx2()));
    d.set("tag_i", tag());
    d.set("second_i", second);
    d.set("wall_i", wall);
    d.set("top_tag_i", tags[top]);
    d.set("top_i2_i", ends[top]);
    d.bench.settle();
    d.see("ack_i", d.get("emit_o"));
  }
  void clock() {
    const int top_tag = tags[(d.get("sp_o") + 3) % 4], cur = d.get("cur_o") & 1;
    if (d.get("push_en_o")) {
      tags[d.get("sp_o")] = tag();
      ends[d.get("sp_o")] = d.i2();
    }
    const bool down = d.get("descend_o"), up = d.get("climb_o"), restart = d.get("restart_o");
    const int left = d.i1();
    if (d.state() == StateReturn) wall = false;
    d.clock();
    ++c;
    if (restart) {
      depth = 0, level = 2, second = false;
    } else if (down && level == 7) {
      if (walls.count({left, tag()})) wall = true;
      else second = true;
    } else if (second && !up) {
      second = false, ++depth, level = 0;
    } else if (down) {
      if (level < 4 && depth > 0) wall = cur;
      level = level == 2 && depth == 0 ? 6 : level == 3 ? 6 : level + 1;
    } else if (up && depth != top_tag >> LevelBits) {
      second = true, --depth, level = 7;
    } else if (up) {
      second = false, level = top_tag & 7;
    }
    settle();
  }
  /// Runs to clock `at` and checks the row of the table.
  void expect(int at, int state, int i1, int i2, int idx2, int depth_now, int level_now) {
    while (c < at) clock();
    const std::vector<int> row{d.state(), d.i1(), d.i2(), d.idx2(), depth, level};
    EXPECT_EQ(row, (std::vector<int>{state, i1, i2, idx2, depth_now, level_now})) << "c = " << c;
  }
};

template <class Unit>
using SubdividerClocksTest = SubdividerTest<Unit>;
TYPED_TEST_SUITE(SubdividerClocksTest, Twins);

// 9.9, all rows.
TYPED_TEST(SubdividerClocksTest, Frame2RunsAsInTheContract) {
  auto& d = this->dut;
  Frame2<TypeParam> f(d);
  const int adjusting[] = {0, 512, 640, 639};
  for (int n = 0; n < 4; ++n) f.expect(50 + n, StateLeft, 0, 639, adjusting[n], 0, 2);
  f.expect(54, StateRight, 0, 639, 639, 0, 2);
  EXPECT_EQ(d.step(), -256);
  const int halves[] = {383, 255, 319, 287, 303, 311, 315, 317, 318};
  for (int n = 0; n < 9; ++n) f.expect(55 + n, StateBisect, 0, 639, halves[n], 0, 2);
  EXPECT_TRUE(d.get("push_en_o")) << "c = 63";
  EXPECT_EQ(d.step(), 0) << "c = 63: dr2 stands on the left pixel";
  EXPECT_EQ(d.get("cur_o"), 6);
  f.expect(64, StateLeft, 0, 318, 318, 0, 6);
  EXPECT_EQ(d.get("sp_o"), 1);
  EXPECT_EQ(d.get("sd_o"), 1);
  EXPECT_EQ(d.get("ray_signs_o"), 3);
  f.expect(73, StateBisect, 0, 318, 255, 0, 6);
  EXPECT_TRUE(d.get("push_en_o"));
  EXPECT_EQ(d.step(), -1);
  f.expect(83, StateBisect, 0, 254, 223, 0, 7);
  EXPECT_TRUE(d.get("push_en_o"));
  f.expect(84, StateLeft, 0, 222, 222, 0, 7);
  EXPECT_TRUE(f.second);
  f.expect(85, StateLeft, 0, 222, 222, 1, 0);
  f.expect(102, StateBisect, 0, 222, 127, 1, 6);
  EXPECT_TRUE(d.get("push_en_o"));
  f.expect(103, StateLeft, 0, 127, 127, 1, 7);
  EXPECT_EQ(d.get("sp_o"), 0);
  EXPECT_EQ(d.get("sd_o"), 4);
  f.expect(111, StateBisect, 0, 127, 28, 1, 7);
  f.expect(112, StateLeft, 0, 27, 27, 1, 7);
  EXPECT_EQ(d.get("sp_o"), 1);
  EXPECT_EQ(d.get("sd_o"), 4);
  f.expect(127, StateLeft, 0, 0, 0, 2, 7);
  EXPECT_TRUE(d.get("descend_o")) << "a one-pixel interval descends in LEFT";
  f.expect(135, StateLeft, 0, 0, 0, 3, 7);
  EXPECT_TRUE(d.get("emit_o"));
  EXPECT_EQ(d.step(), 1);
  f.expect(136, StateReturn, 0, 0, 1, 2, 7);
  EXPECT_TRUE(d.get("copy_sub_o"));
  EXPECT_EQ(d.step(), 32);
  f.expect(137, StateReturn, 0, 0, 33, 2, 6);
  EXPECT_FALSE(d.get("copy_sub_o"));
  EXPECT_EQ(d.step(), -4);
  f.expect(138, StateLeft, 1, 27, 29, 2, 6);
  EXPECT_EQ(d.step(), -2);
  f.expect(139, StateLeft, 1, 27, 27, 2, 6);
  f.expect(164, StateLeft, 1, 16, 16, 4, 1);
  EXPECT_TRUE(d.get("emit_o"));
  // Return over three rooms.
  f.expect(179, StateLeft, 17, 27, 27, 4, 7);
  EXPECT_EQ(d.get("sd_o"), 3);
  f.expect(180, StateReturn, 17, 27, 28, 3, 7);
  f.expect(181, StateReturn, 17, 27, 156, 2, 7);
  f.expect(182, StateReturn, 17, 27, 124, 1, 7);
  EXPECT_TRUE(f.second);
  f.expect(183, StateReturn, 17, 27, 128, 1, 7);
  EXPECT_FALSE(f.second);
  f.expect(184, StateLeft, 28, 127, 127, 1, 7);
  f.expect(186, StateLeft, 28, 127, 127, 1, 7);
  EXPECT_TRUE(d.get("emit_o")) << "length 100, section 14";
  f.expect(194, StateLeft, 128, 222, 222, 1, 7);
  EXPECT_TRUE(d.get("emit_o")) << "length 95, section 14";
  // Underflow restart.
  f.expect(212, StateLeft, 223, 254, 254, 1, 7);
  EXPECT_TRUE(d.get("emit_o"));
  EXPECT_EQ(d.get("sd_o"), 0);
  f.expect(213, StateReturn, 223, 254, 255, 0, 7);  // a stale climb, 11.8
  EXPECT_TRUE(d.get("restart_o"));
  EXPECT_TRUE(d.get("copy_sub_o"));
  EXPECT_EQ(d.step(), 0);
  d.see("i2_init_i", 639);
  f.expect(214, StateLeft, 255, 639, 255, 0, 2);
  EXPECT_EQ(d.step(), 512);
  f.expect(215, StateLeft, 255, 639, 767, 0, 2);
  EXPECT_EQ(d.step(), -128);
  f.expect(216, StateLeft, 255, 639, 639, 0, 2);
  EXPECT_EQ(d.step(), 0);
}

}  // namespace
}  // namespace racebeam
