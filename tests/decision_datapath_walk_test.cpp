// Promises of sc/decision_datapath.h: random walks against geometry, contract sections 11.2
// to 11.7.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "tests/decision_datapath_bench.h"

namespace racebeam {
namespace {

/// 11.2: decision axis and inversion by place.
bool expected_bit(int level, int face, bool dom, const vec3& corner, const vec3& dr) {
  const int axis = level == 6 ? 2 : level == 7 ? (dom ? 0 : 1) : (face + 1 + (level & 1)) % 3;
  const bool inverted = level == 6 ? false : (axis == 1) != (level == 0 || level == 3);
  return ge(axis, corner, dr) != inverted;
}

/// Rooms anywhere, of any size: all arithmetic is modulo 4096.
Box random_scene(int room) {
  std::mt19937 random(room);
  Box box;
  for (int a = 0; a < 3; ++a) {
    box.centre[a] = static_cast<int>(random() % 4096) - 2048;
    box.half[a] = static_cast<int>(random() % 1024);
  }
  return box;
}

/// Walks at random down to walls and up to any place on the way, and checks everything.
template <class Unit>
struct Walk {
  Dut<Unit>& d;
  int limit;  // depth at which a wall is forced
  int deepest = 0;
  std::mt19937 random;
  Place p;
  std::vector<int> stack = std::vector<int>(16, 0);

  Walk(Dut<Unit>& d, int limit, unsigned seed) : d(d), limit(limit), random(seed) {
    d.scene = random_scene;
  }
  int upto(int n) { return static_cast<int>(random() % n); }
  void check() {
    ASSERT_EQ(d.depth(), p.depth());
    ASSERT_EQ(d.level(), p.level);
    ASSERT_EQ(d.get("second_o"), p.second);
    ASSERT_EQ(d.get("room_o"), p.rooms.back());
    ASSERT_EQ(d.corner(), p.corner(d.scene)) << p.depth() << '.' << p.level;
    const bool root = p.depth() == 0 && p.level == 2;
    ASSERT_EQ(d.get("mask_o"), root ? 14 : 1);
    if (p.second) return;
    for (const int state : {StateLeft, StateRight}) {
      const vec3 dr{upto(1024) - 512, upto(1024) - 512, upto(1024) - 512};
      d.set("state_i", state);
      d.bench.drive(state == StateLeft ? "dr1" : "dr2", "_i", dr);
      d.bench.settle();
      const int signs = (dr[2] < 0) << 2 | (dr[1] < 0) << 1 | (dr[0] < 0);
      ASSERT_EQ(d.get("dec_o") >> 1, signs);
      if (!root) {
        ASSERT_EQ(d.bit(), expected_bit(p.level, p.face(), p.doms[p.depth()], d.corner(), dr))
            << p.depth() << '.' << p.level;
      }
    }
  }
  void begin() {
    const vec3 position{upto(512) - 256, upto(512) - 256, upto(512) - 256};
    p = Place();
    p.signs = upto(8);
    p.rooms = {upto(511)};
    for (int a = 0; a < 3; ++a) p.camera[a] = random_scene(p.rooms[0]).centre[a] - position[a];
    d.start(position, p.rooms[0]);
    check();
  }
  /// One descent (a room change in two clocks); returns whether a wall was hit.
  bool descend() {
    const bool bit = upto(p.level < 4 ? 8 : 2) == 0;
    const int depth = p.depth(), face = p.new_face(bit);
    bool wall = false;
    int hit_face = p.face();
    d.ask_descend(p.signs, bit, upto(4) ? upto(511) : SolidRoom);
    const int neighbour = d.get("neighbour_i");
    EXPECT_EQ(d.get("fwrite_o"), p.level == 7 && neighbour != SolidRoom);
    if (p.level == 7) {
      EXPECT_EQ(d.get("look_axis_o"), face);
      EXPECT_EQ(d.get("look_signs_o"), p.signs);
      if (depth) {
        EXPECT_EQ(d.get("fdata_o"), p.code());
      }
      stack[depth] = d.get("fdata_o");
      wall = neighbour == SolidRoom || depth == limit;
      hit_face = face;
    } else if (depth && p.level < 4) {
      wall = bit;
    }
    d.clock();
    if (p.level == 7 && neighbour != SolidRoom) {
      p.second = true;
      p.rooms.push_back(neighbour);
      p.faces.resize(depth + 1), p.faces.push_back(face);
      p.doms.resize(depth + 1), p.doms.push_back(0);
      check_second(wall, hit_face);
      if (wall && upto(2)) d.ask_climb(2, p.signs, stack[depth], upto(511), StateLeft);  // 11.7
      d.clock();
      p.second = false, p.level = 0;
    } else if (p.level == 6) {
      p.doms[depth] = bit, p.level = 7;
    } else if (p.level < 4) {
      p.level = depth == 0 || p.level == 3 ? 6 : p.level + 1;
    }
    EXPECT_EQ(d.get("wall_o"), wall);
    if (wall) {
      EXPECT_EQ(d.get("hit_face_o"), hit_face);
    }
    check();
    return wall;
  }
  /// The corner half way stands at the camera; the wall of the last depth shows already.
  void check_second(bool wall, int hit_face) {
    EXPECT_TRUE(d.get("second_o"));
    EXPECT_EQ(d.get("tag_o"), tag_of(p.depth(), 7));
    EXPECT_EQ(d.corner(), p.corner(d.scene));
    EXPECT_EQ(d.get("wall_o"), wall);
    if (wall) {
      EXPECT_EQ(d.get("hit_face_o"), hit_face);
    }
  }
  /// A return to a place on the way: a clock for each room left and one to arrive, or one clock.
  void climb() {
    if (p.depth() == 0 && p.level == 2) return;
    int td, level;
    do {
      td = upto(p.depth() + 1);
      level = std::array<int, 6>{0, 1, 2, 3, 6, 7}[upto(6)];
    } while ((td == p.depth() && level >= p.level) || (td == 0 && level < 6 && level != 2));
    const int target = tag_of(td, level);
    for (int n = 0; d.get("tag_o") != target || d.get("second_o"); ++n) {
      ASSERT_LT(n, 20);
      const int depth = p.depth();
      const bool leave = td != depth;
      d.ask_climb(target, p.signs, depth ? stack[depth - 1] : 0,
                  leave ? p.rooms[depth - 1] : upto(511), n ? StateReturn : StateLeft);
      if (leave) {
        ASSERT_EQ(d.get("look_axis_o"), p.face());
        ASSERT_EQ(d.get("look_signs_o"), ~p.signs & 7);
      }
      const bool wall = d.get("wall_o");
      d.clock();
      EXPECT_EQ(d.get("wall_o"), n ? 0 : wall) << "cleared in RETURN only";
      p.second = false;
      if (leave) {
        p.rooms.resize(depth);
        p.level = 7;
        ASSERT_EQ(d.get("second_o"), 1);
        ASSERT_EQ(d.get("tag_o"), tag_of(depth - 1, 7));
        ASSERT_EQ(d.get("room_o"), p.rooms.back());
        Place half = p;
        half.second = true, half.rooms.push_back(0);
        ASSERT_EQ(d.corner(), half.corner(d.scene));
      } else {
        p.level = level;
        check();
      }
    }
    d.set("state_i", StateReturn);
    d.set("climb_i", 0);
    d.clock();  // the pop
    EXPECT_FALSE(d.get("wall_o"));
  }
  void run(int walks) {
    for (int walk = 0; walk < walks && !testing::Test::HasFailure(); ++walk) {
      begin();
      for (int leg = 0; leg < 12 && !testing::Test::HasFailure(); ++leg) {
        bool wall = false;
        for (int n = 0; !wall && n < 150 && !testing::Test::HasFailure(); ++n) wall = descend();
        deepest = std::max(deepest, p.depth());
        climb();
      }
    }
  }
};

template <class Unit>
using DecisionDatapathWalkTest = DecisionDatapathTest<Unit>;
TYPED_TEST_SUITE(DecisionDatapathWalkTest, Twins);

// 11.5, 11.6: descents and climbs, all levels, faces and signs.
TYPED_TEST(DecisionDatapathWalkTest, CornerIsWhereGeometryPutsItOnRandomWalks) {
  constexpr unsigned Seed = 115;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  Walk<TypeParam> walk(this->dut, 8, Seed);
  walk.run(400);
  EXPECT_EQ(walk.deepest, 9);
}

void expect_wall_at(int depth, const knobs& k) {
  Dut<decision_datapath> d(k);
  Walk<decision_datapath> walk(d, depth, 200 + depth);
  walk.run(100);
  EXPECT_EQ(walk.deepest, depth + 1);
}

TEST(DecisionDatapathWalkKnobs, MaxRoomDepth2ForcesTheWallAtDepth2) {
  knobs k;
  k.max_room_depth = 2;
  expect_wall_at(2, k);
}

TEST(DecisionDatapathWalkKnobs, MaxRoomDepthIsBoundByTheFaceStack) {
  knobs k;
  k.max_room_depth = 14;
  k.face_stack_depth = 4;
  expect_wall_at(3, k);
}

}  // namespace
}  // namespace racebeam
