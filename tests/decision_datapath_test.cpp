// Promises of sc/decision_datapath.h: contract sections 5.4, 11, 13 (corner controls) and 20.3.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/decision_datapath.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "sc/navigator.h"
#include "sc/subdivider.h"
#include "tb/unit_bench.h"

namespace racebeam {
namespace {

constexpr int tag_of(int depth, int level) { return depth << LevelBits | level; }
constexpr int room_of(int i, int j, int k) { return k << 8 | j << 4 | i; }

/// Depth, level, second.
using At = std::array<int, 3>;

/// A room's centre and half sizes.
struct Box {
  vec3 centre, half;
};

/// 11.3: T(x, m), by pairs of bits.
int product(int x, int m) {
  int sum = 0;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 9; ++j)
      if ((x >> i & 1) && (m >> j & 1) && i + j >= 5) sum += 1 << (i + j - 5);
  return sum;
}

/// 11.3: the comparison for a decision axis.
bool ge(int axis, const vec3& corner, const vec3& dr) {
  const int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
  if (corner[b] < 0) return true;
  if (corner[a] < 0) return false;
  int ca = corner[a], cb = corner[b];
  for (int r = 0; r < 3 && (ca > 255 || cb > 255); ++r) ca >>= 1, cb >>= 1;
  const int ma = dr[a] < 0 ? -dr[a] - 1 : dr[a], mb = dr[b] < 0 ? -dr[b] - 1 : dr[b];
  return product(ca, mb) >= product(cb, ma);
}

/// 11.2: decision axis and inversion by place.
bool expected_bit(int level, int face, bool dom, const vec3& corner, const vec3& dr) {
  const int axis = level == 6 ? 2 : level == 7 ? (dom ? 0 : 1) : (face + 1 + (level & 1)) % 3;
  const bool inverted = level == 6 ? false : (axis == 1) != (level == 0 || level == 3);
  return ge(axis, corner, dr) != inverted;
}

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;
  std::function<Box(int)> scene = [](int) { return Box{{0, 0, 0}, {128, 256, 128}}; };

  explicit Dut(const knobs& k = {}) : unit("dut", k), bench(unit) {}

  int get(const char* port) { return bench[port].value(); }
  void set(const char* port, int value) { bench[port].drive(value); }
  vec3 corner() { return bench.read("corner"); }
  int depth() { return get("tag_o") >> LevelBits; }
  int level() { return get("tag_o") & 7; }
  At place() { return {depth(), level(), get("second_o")}; }
  bool bit() { return get("dec_o") & 1; }
  /// The scene answers for the room; outputs follow.
  void settle() {
    const Box box = scene(get("room_o"));
    bench.drive("position", "_i", box.centre);
    bench.drive("half_size", "_i", box.half);
    bench.settle();
  }
  void clock() {
    settle();
    bench.clock();
    set("descend_i", 0);
    set("leave_i", 0);
    set("climb_i", 0);
    set("restart_i", 0);
    set("tracer_reset_i", 0);
    set("active_start_i", 0);
    settle();
  }
  void start(const vec3& position, int room) {
    set("neighbour_i", SolidRoom);
    bench.drive("nav_position", "_i", position);
    set("nav_room_i", room);
    set("tracer_reset_i", 1);
    clock();
  }
  void ask_descend(int signs, bool bit, int neighbour = SolidRoom) {
    set("state_i", StateLeft);
    set("descend_i", 1);
    set("ray_signs_i", get("tag_o") == 2 ? ~signs : signs);  // 0.2 gets them with the decision
    set("cur_i", signs << 1 | int(bit));
    set("leave_i", level() == 7 ? 2 | int(bit) : 0);
    set("neighbour_i", neighbour);
    settle();
  }
  void descend(int signs, bool bit, int neighbour = SolidRoom) {
    ask_descend(signs, bit, neighbour);
    clock();
  }
  void ask_climb(int target, int signs, int popped, int neighbour, int state = StateReturn) {
    set("state_i", state);
    set("climb_i", 1);
    set("top_tag_i", target);
    set("ray_signs_i", signs);
    set("fread_i", popped);
    set("neighbour_i", neighbour);
    settle();
  }
  void climb(int target, int signs, int popped = 0, int neighbour = 0, int state = StateReturn) {
    ask_climb(target, signs, popped, neighbour, state);
    clock();
  }
  /// Level 6 at the root with this far corner and ray.
  bool root_bit(const vec3& far_corner, const vec3& dr) {
    scene = [far_corner](int) { return Box{{0, 0, 0}, far_corner}; };
    start({0, 0, 0}, 4);
    descend(0, false);
    bench.drive("dr1", "_i", dr);
    bench.settle();
    return bit();
  }
};

template <class Unit>
class DecisionDatapathTest : public testing::Test {
 protected:
  Dut<Unit> dut;
};

using Twins = testing::Types<decision_datapath>;
TYPED_TEST_SUITE(DecisionDatapathTest, Twins);

Box pillars(int room) { return {{256 * (room & 15), 0, 256 * (room >> 4 & 15)}, {128, 256, 128}}; }

// 11.10: frame 2, y = -240.
TYPED_TEST(DecisionDatapathTest, TraceOfFrame2MovesTheCornerAsInTheContract) {
  auto& d = this->dut;
  constexpr int Signs = 3;
  d.scene = pillars;
  d.set("y_i", -240);
  d.set("scene_interlace_i", 1);
  d.start({0, -224, -1}, room_of(4, 0, 0));
  EXPECT_EQ(d.place(), (At{0, 2, 0}));
  EXPECT_EQ(d.corner(), (vec3{0, -224, -1}));
  EXPECT_EQ(d.get("mask_o"), 14);
  d.descend(Signs, false);
  EXPECT_EQ(d.place(), (At{0, 6, 0}));
  EXPECT_EQ(d.corner(), (vec3{128, 480, 127})) << "c = 64";
  EXPECT_EQ(d.get("mask_o"), 1);
  d.descend(Signs, false);
  EXPECT_EQ(d.place(), (At{0, 7, 0}));
  d.ask_descend(Signs, true, room_of(3, 0, 0));
  EXPECT_EQ(d.get("axis_o"), 0);
  EXPECT_EQ(d.get("signs_o"), Signs);
  EXPECT_TRUE(d.get("fwrite_o"));
  d.clock();
  EXPECT_EQ(d.place(), (At{0, 7, 1}));
  EXPECT_EQ(d.corner(), (vec3{1024, 224, -1})) << "c = 84";
  EXPECT_EQ(d.get("room_o"), room_of(3, 0, 0));
  d.clock();
  const vec3 corners[] = {{128, 480, 127}, {128, 480, 127}, {128, -32, -129}, {128, -32, -129}};
  for (int level = 0; level < 4; ++level) {
    EXPECT_EQ(d.place(), (At{1, level, 0}));
    EXPECT_EQ(d.corner(), corners[level]) << "1." << level;
    d.descend(Signs, false);
  }
  EXPECT_EQ(d.place(), (At{1, 6, 0}));
  EXPECT_EQ(d.corner(), (vec3{384, 480, 127})) << "c = 93";
  // On to 2,0,0 through x and to 2,1,0 through z.
  d.descend(Signs, false);
  d.descend(Signs, true, room_of(2, 0, 0));
  for (int n = 0; n < 6; ++n) d.descend(Signs, false);
  EXPECT_EQ(d.place(), (At{2, 7, 0})) << "the clock of second counts as a descent too";
  d.ask_descend(Signs, false, room_of(2, 1, 0));
  EXPECT_EQ(d.get("axis_o"), 2);
  EXPECT_EQ(d.get("fdata_o"), 0) << "face 0, dom 0";
  d.clock();
  for (int n = 0; n < 6; ++n) d.descend(Signs, false);
  EXPECT_EQ(d.place(), (At{3, 7, 0}));
  EXPECT_EQ(d.corner(), (vec3{640, 480, 383})) << "c = 134";
  EXPECT_FALSE(d.get("wall_o"));
  d.descend(Signs, true, SolidRoom);
  EXPECT_TRUE(d.get("wall_o"));
  EXPECT_EQ(d.get("hit_face_o"), 0) << "x wall, index 3";
  EXPECT_EQ(d.place(), (At{3, 7, 0}));
  d.ask_climb(tag_of(2, 6), Signs, 0, room_of(2, 0, 0), StateLeft);
  EXPECT_EQ(d.get("axis_o"), 2) << "back through z";
  EXPECT_EQ(d.get("signs_o"), 4);
  d.clock();
  EXPECT_EQ(d.place(), (At{2, 7, 1}));
  EXPECT_EQ(d.corner(), (vec3{1024, 224, -1})) << "c = 136";
  EXPECT_EQ(d.get("room_o"), room_of(2, 0, 0));
  EXPECT_TRUE(d.get("wall_o")) << "cleared by RETURN";
  d.climb(tag_of(2, 6), Signs);
  EXPECT_EQ(d.place(), (At{2, 6, 0}));
  EXPECT_EQ(d.corner(), (vec3{640, 480, 127})) << "c = 137";
  EXPECT_FALSE(d.get("wall_o"));
}

// 11.3, the two examples.
TYPED_TEST(DecisionDatapathTest, ExampleRayDecides0AtLevel6And1AtLevel7) {
  auto& d = this->dut;
  d.start({0, -224, -1}, room_of(4, 0, 0));
  d.bench.drive("dr1", "_i", {-319, -239, 95});
  d.settle();
  EXPECT_EQ(d.get("dec_o") >> 1, 3) << "signs z 0, y 1, x 1";
  d.descend(3, false);
  EXPECT_EQ(d.get("dec_o"), 6);
  d.descend(3, false);
  EXPECT_EQ(d.get("dec_o"), 7);
}

TYPED_TEST(DecisionDatapathTest, LeftDecidesWithDr1AndAllOtherStatesWithDr2) {
  auto& d = this->dut;
  d.start({0, 0, 0}, 4);
  d.bench.drive("dr1", "_i", {-1, 5, 5});
  d.bench.drive("dr2", "_i", {5, 5, -1});
  for (const int state : {StateLeft, StateRight, StateBisect, StateReturn}) {
    d.set("state_i", state);
    d.bench.settle();
    EXPECT_EQ(d.get("dec_o") >> 1, state == StateLeft ? 1 : 4);
  }
}

// 20.3: each T(x, m) is weighed against another product of the same value, both ways round.
TYPED_TEST(DecisionDatapathTest, TruncatedProductsAreThoseOfTheVectors) {
  auto& d = this->dut;
  const int vectors[][3] = {{128, 95, 380},   {127, 318, 1259}, {64, 238, 476},
                            {240, 318, 2385}, {127, 64, 254},   {255, 511, 4068}};
  for (const auto& [x, m, value] : vectors) {
    ASSERT_EQ(product(x, m), value) << "the reference";
    const int near = value == 4068 ? 16 : 1;  // the largest product there is
    int weighed = 0;
    for (int y = 255; y > 0; --y)
      for (int n = 511; n > 0; --n) {
        const int other = product(y, n);
        if (std::abs(other - value) > near || (y == x && n == m) || weighed > 60) continue;
        ++weighed;
        EXPECT_EQ(d.root_bit({x, y, 0}, {n, m, 0}), value >= other) << x << '*' << m;
        EXPECT_EQ(d.root_bit({y, x, 0}, {m, n, 0}), other >= value) << x << '*' << m;
      }
    EXPECT_GT(weighed, 2);
  }
}

TYPED_TEST(DecisionDatapathTest, NegativeRaysHaveOnesComplementMagnitude) {
  auto& d = this->dut;
  EXPECT_TRUE(d.root_bit({32, 32, 0}, {-100, 99, 0})) << "99 >= 99";
  EXPECT_FALSE(d.root_bit({32, 32, 0}, {-101, 99, 0})) << "99 >= 100";
  EXPECT_TRUE(d.root_bit({32, 32, 0}, {-1, 0, 0})) << "0 >= 0";
  EXPECT_TRUE(d.root_bit({32, 32, 0}, {511, -512, 0})) << "511 >= 511";
}

TYPED_TEST(DecisionDatapathTest, NegativeCornersDecideByThemselves) {
  auto& d = this->dut;
  const vec3 level{256, 256, 0};
  EXPECT_TRUE(d.root_bit({0, 0, 0}, level)) << "0 is positive: 0 >= 0";
  EXPECT_FALSE(d.root_bit({0, 100, 0}, level));
  EXPECT_TRUE(d.root_bit({100, 0, 0}, level));
  EXPECT_FALSE(d.root_bit({-1, 0, 0}, level)) << "a negative";
  EXPECT_TRUE(d.root_bit({0, -1, 0}, level)) << "b negative";
  EXPECT_TRUE(d.root_bit({-2048, -1, 0}, level)) << "both: b decides";
}

TYPED_TEST(DecisionDatapathTest, FactorsAreNormalisedTo8Bits) {
  auto& d = this->dut;
  std::mt19937 random(113);
  const auto upto = [&](int n) { return static_cast<int>(random() % n); };
  for (int n = 0; n < 3000; ++n) {
    const vec3 c{upto(1 << (1 + upto(11))), upto(1 << (1 + upto(11))), 0};
    const vec3 dr{upto(1024) - 512, upto(1024) - 512, 0};
    ASSERT_EQ(d.root_bit(c, dr), ge(2, c, dr)) << c[0] << ',' << c[1] << " " << dr[0];
  }
}

/// Where the tracer is, told by geometry: the corner of a room, seen from the camera, mirrored.
struct Place {
  vec3 camera{};
  int signs = 0, level = 2;
  bool second = false;
  std::vector<int> rooms, faces{0}, doms{0};  // by depth; faces: the face entered by

  int depth() const { return static_cast<int>(rooms.size()) - 1 - second; }
  int face() const { return faces[depth()]; }
  int new_face(bool bit) const { return doms[depth()] ? (bit ? 2 : 1) : (bit ? 0 : 2); }
  int code() const { return depth() ? faces[depth()] | doms[depth() - 1] : 0; }

  vec3 corner(const std::function<Box(int)>& scene) const {
    const Box box = scene(rooms[depth()]);
    vec3 c;
    for (int a = 0; a < 3; ++a) {
      const int mirror = signs >> a & 1 ? -1 : 1;
      const bool far = level >= 6 || (level < 2 && a != face());
      if (level == 2 && depth() == 0) c[a] = box.centre[a] - camera[a];
      else c[a] = mirror * (box.centre[a] - camera[a]) + (far ? box.half[a] : -box.half[a]);
      if (second) c[a] = -mirror * camera[a];
      c[a] = wrap_signed(c[a], CornerBits);
    }
    return c;
  }
};

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
      EXPECT_EQ(d.get("axis_o"), face);
      EXPECT_EQ(d.get("signs_o"), p.signs);
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
        ASSERT_EQ(d.get("axis_o"), p.face());
        ASSERT_EQ(d.get("signs_o"), ~p.signs & 7);
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

// 11.5, 11.6: descents and climbs, all levels, faces and signs.
TYPED_TEST(DecisionDatapathTest, CornerIsWhereGeometryPutsItOnRandomWalks) {
  constexpr unsigned Seed = 115;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  Walk<TypeParam> walk(this->dut, 8, Seed);
  walk.run(400);
  EXPECT_EQ(walk.deepest, 9);
}

/// From the root straight down through z faces, until `depth`.7.
template <class Unit>
void go_down(Dut<Unit>& d, int depth) {
  while (d.get("tag_o") != tag_of(depth, 7)) d.descend(0, false, d.level() == 7 ? 5 : SolidRoom);
}

// 11.5, 11.7
TYPED_TEST(DecisionDatapathTest, WallAtDepth8ShowsAClockBeforeDepth9) {
  auto& d = this->dut;
  d.start({0, 0, 0}, 4);
  go_down(d, 7);
  d.descend(0, false, 5);
  EXPECT_FALSE(d.get("wall_o"));
  go_down(d, 8);
  EXPECT_FALSE(d.get("wall_o"));
  d.descend(0, true, 5);
  EXPECT_TRUE(d.get("wall_o"));
  EXPECT_EQ(d.place(), (At{8, 7, 1}));
  EXPECT_EQ(d.get("hit_face_o"), 0) << "the new face";
  d.ask_climb(tag_of(3, 6), 0, 0, 6, StateLeft);  // the hit is accepted in this clock
  d.clock();
  EXPECT_EQ(d.place(), (At{9, 0, 0})) << "the descent completes, the climb is ignored";
  EXPECT_EQ(d.get("room_o"), 5);
  EXPECT_TRUE(d.get("wall_o"));
  d.climb(tag_of(3, 6), 0, 0, 6);
  EXPECT_EQ(d.place(), (At{8, 7, 1}));
  EXPECT_FALSE(d.get("wall_o"));
}

// 11.8
TYPED_TEST(DecisionDatapathTest, StaleClimbFromTheRootRunsToDepth15AndTheRestartUndoesIt) {
  auto& d = this->dut;
  d.start({0, -224, -5}, 4);
  go_down(d, 0);
  d.climb(tag_of(4, 0), 0, 0, 7, StateLeft);
  EXPECT_EQ(d.place(), (At{15, 7, 1}));
  d.set("state_i", StateReturn);
  d.set("restart_i", 1);
  d.clock();
  EXPECT_EQ(d.place(), (At{0, 2, 0}));
  EXPECT_EQ(d.corner(), (vec3{0, -224, -5}));
  EXPECT_EQ(d.get("room_o"), 4);
}

TYPED_TEST(DecisionDatapathTest, RestartAndResetReturnToTheCameraFromAnywhere) {
  auto& d = this->dut;
  for (const char* cause : {"restart_i", "tracer_reset_i"}) {
    d.start({64, -224, 17}, 20);
    go_down(d, 3);
    d.descend(0, true, SolidRoom);
    EXPECT_TRUE(d.get("wall_o"));
    d.set(cause, 1);
    d.clock();
    EXPECT_EQ(d.place(), (At{0, 2, 0})) << cause;
    EXPECT_EQ(d.corner(), (vec3{64, -224, 17})) << cause;
    EXPECT_EQ(d.get("room_o"), 20) << cause;
    EXPECT_FALSE(d.get("wall_o")) << cause;
  }
}

// 11.1: on the nav_line active_start re-roots, a restart does not; elsewhere it is the other way.
TYPED_TEST(DecisionDatapathTest, NavLineRerootsAtActiveStartOnly) {
  auto& d = this->dut;
  d.start({0, -224, 17}, 20);
  go_down(d, 0);
  const vec3 moved = d.corner();
  d.set("active_start_i", 1);
  d.clock();
  EXPECT_EQ(d.place(), (At{0, 7, 0})) << "not the nav_line";
  EXPECT_EQ(d.corner(), moved);
  d.set("nav_line_i", 1);
  d.set("restart_i", 1);
  d.clock();
  EXPECT_EQ(d.place(), (At{0, 7, 0})) << "restart on the nav_line";
  EXPECT_EQ(d.corner(), moved);
  d.set("active_start_i", 1);
  d.clock();
  EXPECT_EQ(d.place(), (At{0, 2, 0}));
  EXPECT_EQ(d.corner(), (vec3{0, -224, 17}));
  d.descend(0, true);
  EXPECT_EQ(d.place(), (At{0, 6, 0})) << "the tree goes on";
  EXPECT_EQ(d.corner(), (vec3{0, -224, 17})) << "the corner is the navigator's";
}

// 13: y = 251 of frame 129.
TYPED_TEST(DecisionDatapathTest, NavLineTraceOfFrame129) {
  auto& d = this->dut;
  d.scene = pillars;
  d.set("y_i", 251);
  d.set("scene_interlace_i", 1);
  d.set("velocity_z_i", -1);
  d.start({0, -224, -128}, room_of(4, 0, 0));
  d.set("nav_line_i", 1);
  d.set("active_start_i", 1);
  d.clock();
  struct {
    int op, move;
    vec3 corner;
    int j;
  } const rows[] = {{CornerAddVelocity, 0, {0, -224, -129}, 0},
                    {CornerAddS, 0, {128, 32, -1}, 0},
                    {CornerLeavePlus, 1, {-1024, -224, -129}, 1},
                    {CornerAddR, 0, {0, -224, 127}, 1},
                    {CornerHold, 0, {0, -224, 127}, 1}};
  EXPECT_EQ(d.corner(), (vec3{0, -224, -128})) << "c = 320";
  d.set("nav_axis_i", 2);
  d.set("neighbour_i", room_of(4, 1, 0));
  for (const auto& row : rows) {
    d.set("nav_op_i", row.op);
    d.set("nav_move_i", row.move);
    d.settle();
    EXPECT_EQ(d.get("axis_o"), 2);
    EXPECT_EQ(d.get("signs_o"), 0);
    d.clock();
    EXPECT_EQ(d.corner(), row.corner);
    EXPECT_EQ(d.get("room_o"), room_of(4, row.j, 0));
  }
}

TYPED_TEST(DecisionDatapathTest, NavLineOperationsAddSizesAndDistances) {
  auto& d = this->dut;
  d.scene = [](int) { return Box{{700, -272, -900}, {96, 16, 80}}; };
  const vec3 start{64, -224, 100};
  const auto after = [&](int op, int velocity = 0) {
    d.start(start, 9);
    d.set("nav_line_i", 1);
    d.set("nav_op_i", op);
    d.set("velocity_z_i", velocity);
    d.clock();
    d.set("nav_line_i", 0);
    return d.corner();
  };
  EXPECT_EQ(after(CornerHold, -1), start);
  EXPECT_EQ(after(CornerAddVelocity, -2), (vec3{64, -224, 98}));
  EXPECT_EQ(after(CornerAddVelocity, 1), (vec3{64, -224, 101}));
  EXPECT_EQ(after(CornerAddS), (vec3{160, -208, 180}));
  EXPECT_EQ(after(CornerSubtract2S), (vec3{-128, -256, -60}));
  EXPECT_EQ(after(CornerLeavePlus), (vec3{-732, 32, 920}));
  EXPECT_EQ(after(CornerLeaveMinus), (vec3{-540, 64, 1080}));
  EXPECT_EQ(after(CornerAddR), (vec3{764, -496, -800}));
}

TYPED_TEST(DecisionDatapathTest, NavLineLooksWhereTheNavigatorLooks) {
  auto& d = this->dut;
  d.start({0, 0, 0}, 4);
  d.set("nav_line_i", 1);
  d.set("ray_signs_i", 5);
  for (int axis = 0; axis < 3; ++axis)
    for (const int negative : {0, 1}) {
      d.set("nav_axis_i", axis);
      d.set("nav_negative_i", negative);
      d.settle();
      EXPECT_EQ(d.get("axis_o"), axis);
      EXPECT_EQ(d.get("signs_o") >> axis & 1, negative);
    }
}

// 11.6, the table of the interlace operation: z after each of its rows.
template <class Unit>
void expect_interlace(Dut<Unit>& d, bool on, const std::string& why) {
  constexpr int Z = 50, S = 128;
  for (const int sign : {0, 1}) {
    const int signs = sign << 2, mirror = sign ? -1 : 1, plus = on;
    SCOPED_TRACE(why + (sign ? ", z sign 1" : ", z sign 0"));
    d.scene = pillars;
    d.start({3, 5, Z}, room_of(4, 3, 0));
    d.descend(signs, false);
    EXPECT_EQ(d.corner(), (vec3{3 + 128, 5 + 256, mirror * (Z + plus) + S}));
    d.descend(signs, false);
    d.climb(tag_of(0, 2), signs);
    EXPECT_EQ(d.place(), (At{0, 2, 0}));
    const int left_over = on && sign ? 2 : 0;
    EXPECT_EQ(d.corner(), (vec3{3, 5, Z + left_over})) << "climb within depth 0";
    // And from deeper: down again, into the room beyond x, and back.
    d.start({3, 5, Z}, room_of(4, 3, 0));
    d.descend(signs, false);
    d.descend(signs, false);
    d.descend(signs, true, room_of(5, 3, 0));
    d.clock();
    EXPECT_EQ(d.place(), (At{1, 0, 0}));
    d.climb(tag_of(0, 2), signs, 0, room_of(4, 3, 0));
    d.climb(tag_of(0, 2), signs);
    EXPECT_EQ(d.place(), (At{0, 2, 0}));
    EXPECT_EQ(d.corner(), (vec3{3, 5, Z + plus})) << "arrival from deeper";
    d.descend(signs, false);
    EXPECT_EQ(d.corner()[2], mirror * (Z + 2 * plus) + S) << "they add up";
  }
}

TYPED_TEST(DecisionDatapathTest, OddLinesShowThePreviousPositionWithItsResidues) {
  auto& d = this->dut;
  d.set("scene_interlace_i", 1);
  for (const int y : {-239, 1, 237}) {
    d.set("y_i", y);
    expect_interlace(d, true, "y = " + std::to_string(y));
  }
}

TYPED_TEST(DecisionDatapathTest, InterlaceNeedsOddLineSceneAndPin) {
  auto& d = this->dut;
  d.set("scene_interlace_i", 1);
  d.set("y_i", -240);
  expect_interlace(d, false, "even line");
  d.set("y_i", -239);
  d.set("no_interlace_i", 1);
  expect_interlace(d, false, "pin");
  d.set("no_interlace_i", 0);
  d.set("scene_interlace_i", 0);
  expect_interlace(d, false, "scene");
}

// Knobs.
void expect_wall_at(int depth, const knobs& k) {
  Dut<decision_datapath> d(k);
  Walk<decision_datapath> walk(d, depth, 200 + depth);
  walk.run(100);
  EXPECT_EQ(walk.deepest, depth + 1);
}

TEST(DecisionDatapathKnobs, MaxRoomDepth2ForcesTheWallAtDepth2) {
  knobs k;
  k.max_room_depth = 2;
  expect_wall_at(2, k);
}

TEST(DecisionDatapathKnobs, MaxRoomDepthIsBoundByTheFaceStack) {
  knobs k;
  k.max_room_depth = 14;
  k.face_stack_depth = 4;
  expect_wall_at(3, k);
}

TEST(DecisionDatapathKnobs, WideFactorsAndNoCutGiveTheSignOfTheExactProduct) {
  knobs k;
  k.corner_factor_bits = 12;
  k.partial_products_cut = 0;
  Dut<decision_datapath> d(k);
  std::mt19937 random(303);
  const auto upto = [&](int n) { return static_cast<int>(random() % n); };
  int differs = 0;
  for (int n = 0; n < 4000; ++n) {
    const vec3 c{upto(2048), upto(2048), 0};
    vec3 dr{upto(512), 0, 0};
    dr[1] = c[0] ? std::min(511, c[1] * dr[0] / c[0] + upto(2)) : upto(512);  // close calls
    const bool exact = c[0] * dr[1] >= c[1] * dr[0];
    ASSERT_EQ(d.root_bit(c, dr), exact) << c[0] << ',' << c[1] << ' ' << dr[0] << ',' << dr[1];
    differs += exact != ge(2, c, dr);
  }
  EXPECT_GT(differs, 100) << "and the chip's would often differ";
}

// skip_shared_edges: a portal edge on the edge of the face needs no decision.
void expect_levels(const vec3& half, const vec3& centre, const std::vector<int>& levels) {
  knobs k;
  k.skip_shared_edges = 1;
  Dut<decision_datapath> d(k);
  d.scene = [&](int room) {
    return room == 4 ? Box{{0, 0, 0}, {128, 256, 128}} : Box{centre, half};
  };
  d.start({10, -20, 30}, 4);
  d.descend(0, false);
  d.descend(0, false);
  d.descend(0, true, 5);  // through +x
  d.clock();
  Place p;
  p.camera = {-10, 20, -30};
  p.rooms = {4, 5}, p.faces = {0, 0}, p.doms = {0, 0};
  for (const int level : levels) {
    p.level = level;
    EXPECT_EQ(d.place(), (At{1, level, 0}));
    EXPECT_EQ(d.corner(), p.corner(d.scene)) << "1." << level;
    d.descend(0, false);
  }
  EXPECT_EQ(d.place(), (At{1, 7, 0}));
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
    p.level = *level;
    d.climb(tag_of(1, *level), 0);
    EXPECT_EQ(d.place(), (At{1, *level, 0}));
    EXPECT_EQ(d.corner(), p.corner(d.scene)) << "back at 1." << *level;
  }
}

// Through an x face levels 0 and 2 test the far and near edge in z, 1 and 3 those in y (11.2).
TEST(DecisionDatapathKnobs, RoomOfTheSameSectionNeedsNoPortalDecision) {
  expect_levels({128, 256, 128}, {256, 0, 0}, {6});
}
TEST(DecisionDatapathKnobs, RoomNarrowerInZIsTestedInZ) {
  expect_levels({128, 256, 96}, {256, 0, 0}, {0, 2, 6});
}
TEST(DecisionDatapathKnobs, RoomLowerInYIsTestedInY) {
  expect_levels({128, 16, 128}, {256, 0, 0}, {1, 3, 6});
}
TEST(DecisionDatapathKnobs, RoomOnTheNearEdgeIsTestedOnTheFarSide) {
  expect_levels({128, 256, 96}, {256, 0, -32}, {0, 6});
}
TEST(DecisionDatapathKnobs, RoomOnTheFarEdgeIsTestedOnTheNearSide) {
  expect_levels({128, 246, 128}, {256, 10, 0}, {3, 6});
}
TEST(DecisionDatapathKnobs, SmallWindowIsTestedOnAllSides) {
  expect_levels({16, 96, 96}, {144, 0, 0}, {0, 1, 2, 3, 6});
}

}  // namespace
}  // namespace racebeam
