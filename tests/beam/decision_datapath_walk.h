// Random walks of decision_datapath through the decision tree, checked by geometry.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "sc/beam/scene.h"
#include "tests/beam/decision_datapath_bench.h"

namespace racebeam {

/// 11.2: decision axis and inversion by place.
inline bool expected_bit(int level, int face, bool dom, const vec3& corner, const vec3& dr) {
  const int axis = level == 6 ? 2 : level == 7 ? (dom ? 0 : 1) : (face + 1 + (level & 1)) % 3;
  const bool inverted = level == 6 ? false : (axis == 1) != (level == 0 || level == 3);
  return ge(axis, corner, dr) != inverted;
}

/// Rooms anywhere, of any size: all arithmetic is modulo 4096.
inline Box random_scene(int room) {
  std::mt19937 random(room);
  Box box;
  for (int a = 0; a < 3; ++a) {
    box.centre[a] = static_cast<int>(random() % 4096) - 2048;
    box.half[a] = static_cast<int>(random() % 1024);
  }
  return box;
}

/// Walks at random down to walls and up to any place on the way, and checks everything. A face has
/// up to `most_portals` portals.
template <class Unit>
struct Walk {
  /// Behind a portal: the room, and the portal that leads back.
  struct Behind {
    int room, back;
  };

  Dut<Unit>& d;
  int limit;  // depth at which a wall is forced
  int most_portals;
  int deepest = 0, moves_beside = 0, last_edges = 0;
  int climbs[2][2] = {};  // other depth, other portal
  std::mt19937 random;
  Place p;
  std::vector<int> stack = std::vector<int>(16, 0);
  std::vector<std::vector<Behind>> ways{{}};  // by depth: the portals of the face entered by

  Walk(Dut<Unit>& d, int limit, unsigned seed, int most_portals = 1)
      : d(d), limit(limit), most_portals(most_portals), random(seed) {
    d.scene = random_scene;
  }
  int upto(int n) { return static_cast<int>(random() % n); }
  int portal() const { return p.portals[p.depth()]; }
  int tag() const { return tag_of(p.depth(), p.level, portal()); }
  void check() {
    ASSERT_EQ(d.get("tag_o"), tag());
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
  void expect_look(int axis, int signs, int portal, int way) {
    EXPECT_EQ(d.get("look_axis_o"), axis);
    EXPECT_EQ(d.get("look_signs_o"), signs);
    EXPECT_EQ(d.get("look_portal_o"), portal);
    EXPECT_EQ(d.get("look_way_o"), way);
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
    const bool bit = upto(p.level < 4 ? (d.several ? 4 : 8) : 2) == 0;
    const int depth = p.depth();
    if (p.level == 7) return leave_room(bit);
    if (depth && p.level < 4 && bit && d.several) {
      const bool last = portal() + 1 == static_cast<int>(ways[depth].size());
      const Behind next = last ? Behind{SolidRoom, upto(4)} : ways[depth][portal() + 1];
      d.ask_descend(p.signs, bit, next.room, next.back);
      expect_look(p.face(), ~p.signs & 7, p.backs[depth], LookNext);
      last_edges += last;
      if (!last) {
        move_beside(next);
        return false;
      }
    } else {
      d.ask_descend(p.signs, bit, upto(4) ? upto(511) : SolidRoom, upto(4));
    }
    EXPECT_FALSE(d.get("fwrite_o"));
    const bool wall = depth && p.level < 4 && bit;
    d.clock();
    if (p.level == 6) p.doms[depth] = bit, p.level = 7;
    else p.level = depth == 0 || p.level == 3 ? 6 : p.level + 1;
    EXPECT_EQ(d.get("wall_o"), wall);
    if (wall) {
      EXPECT_EQ(d.get("hit_face_o"), p.face());
    }
    check();
    return wall;
  }
  /// Through the face: to a wall, or through its portal 0.
  bool leave_room(bool bit) {
    const int depth = p.depth(), face = p.new_face(bit);
    std::vector<Behind> behind;
    if (upto(4))
      for (int n = upto(most_portals); n >= 0; --n)
        behind.push_back({upto(511), d.several ? upto(4) : 0});
    const Behind next = behind.empty() ? Behind{SolidRoom, upto(4)} : behind[0];
    d.ask_descend(p.signs, bit, next.room, next.back);
    EXPECT_EQ(d.get("fwrite_o"), next.room != SolidRoom);
    expect_look(face, p.signs, 0, LookThrough);
    if (depth) {
      EXPECT_EQ(d.get("fdata_o"), p.code());
    }
    stack[depth] = d.get("fdata_o");
    const bool wall = behind.empty() || depth == limit;
    d.clock();
    if (!behind.empty()) {
      p.second = true;
      p.rooms.push_back(next.room);
      for (auto* list : {&p.faces, &p.doms, &p.portals, &p.backs}) list->resize(depth + 2);
      p.faces.back() = face, p.doms.back() = 0, p.portals.back() = 0, p.backs.back() = next.back;
      ways.resize(depth + 1), ways.push_back(behind);
      check_half(tag_of(depth, 7), next.room, low_bits(TagBits));
      // The wall of the last depth shows already; 11.7: a climb in this clock is ignored.
      EXPECT_EQ(d.get("wall_o"), wall);
      if (wall && upto(2)) d.ask_climb(2, p.signs, stack[depth], upto(511), StateLeft);
      d.clock();
      p.second = false, p.level = 0;
    }
    EXPECT_EQ(d.get("wall_o"), wall);
    if (wall) {
      EXPECT_EQ(d.get("hit_face_o"), face);
    }
    check();
    return wall;
  }
  /// Past the edge of a portal: two clocks to the room behind the next.
  void move_beside(const Behind& next) {
    ++moves_beside;
    const int depth = p.depth();
    EXPECT_FALSE(d.get("fwrite_o"));
    d.clock();
    p.rooms.back() = next.room, ++p.portals[depth], p.backs[depth] = next.back, p.level = 0;
    check_half(tag(), next.room);
    if (upto(2)) d.ask_climb(2, p.signs, upto(64), upto(511), StateLeft);  // 11.7: ignored
    d.clock();
    EXPECT_FALSE(d.get("wall_o"));
    check();
  }
  /// Half way; `bits` of the tag are known.
  void check_half(int tag, int room, int bits = low_bits(TagPortBits)) {
    EXPECT_TRUE(d.get("second_o"));
    EXPECT_EQ(d.get("tag_o") & bits, tag & bits);
    EXPECT_EQ(d.get("room_o"), room);
    EXPECT_EQ(d.corner(), p.at_camera());
  }
  /// A place on the way, before the present one.
  bool earlier(int depth, int portal, int level) const {
    const int last = p.portals[depth];
    if (depth == 0) return (level == 2 || level > 5) && (p.depth() || level < p.level);
    if (portal < last) return level < 4;
    return depth < p.depth() || level < p.level;
  }
  /// A return to a place on the way: a clock for each room and each portal left and one to arrive,
  /// or one clock.
  void climb() {
    if (p.depth() == 0 && p.level == 2) return;
    int td, portal, level;
    do {
      td = upto(p.depth() + 1);
      portal = td ? upto(p.portals[td] + 1) : 0;
      level = std::array<int, 6>{0, 1, 2, 3, 6, 7}[upto(6)];
    } while (!earlier(td, portal, level));
    const int target = tag_of(td, level, portal);
    const int clocks = p.depth() - td + p.portals[td] - portal + 1;
    ++climbs[td != p.depth()][portal != p.portals[td]];
    for (int n = 0; n < clocks && !testing::Test::HasFailure(); ++n) climb_one(target, n == 0);
    ASSERT_EQ(d.get("tag_o"), target);
    ASSERT_FALSE(d.get("second_o"));
    d.set("state_i", StateReturn);
    d.set("climb_i", 0);
    d.clock();  // the pop
    EXPECT_FALSE(d.get("wall_o"));
  }
  void climb_one(int target, bool first) {
    const int depth = p.depth(), td = target >> LevelBits & low_bits(DepthBits);
    const bool leave = td != depth, beside = !leave && target >> TagBits != portal();
    const Behind to = leave    ? Behind{p.rooms[depth - 1], upto(4)}
                      : beside ? ways[depth][portal() - 1]
                               : Behind{upto(511), upto(4)};
    d.ask_climb(target, p.signs, depth ? stack[depth - 1] : 0, to.room,
                first ? StateLeft : StateReturn, to.back);
    if (leave || beside)
      expect_look(p.face(), ~p.signs & 7, p.backs[depth], leave ? LookThrough : LookPrevious);
    const bool wall = d.get("wall_o");
    d.clock();
    EXPECT_EQ(d.get("wall_o"), first ? wall : 0) << "cleared in RETURN only";
    if (leave) {
      p.rooms.resize(depth);
      p.level = 7;
    } else if (beside) {
      p.rooms.back() = to.room, --p.portals[depth], p.backs[depth] = to.back, p.level = 0;
    } else {
      p.level = target & low_bits(LevelBits);
      check();
      return;
    }
    check_half(tag(), to.room);
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

}  // namespace racebeam
