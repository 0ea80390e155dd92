// decision_datapath alone on the bench: the rooms and the tracer around it, and what the contract
// says of its answers, in plain words.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <vector>

#include "sc/beam/decision_datapath.h"
#include "sc/beam/navigator.h"
#include "sc/beam/subdivider.h"
#include "tb/twin/unit_bench.h"
#include "tests/support/own_rtl.h"

namespace racebeam {

constexpr int tag_of(int depth, int level, int portal = 0) {
  return portal << TagBits | depth << LevelBits | level;
}
constexpr int room_of(int i, int j, int k) { return k << 8 | j << 4 | i; }

/// Depth, level, second.
using At = std::array<int, 3>;

/// A room's centre and half sizes.
struct Box {
  vec3 centre, half;
};

inline Box pillars(int room) {
  return {{256 * (room & 15), 0, 256 * (room >> 4 & 15)}, {128, 256, 128}};
}

/// 11.3: T(x, m), by pairs of bits.
inline int product(int x, int m) {
  int sum = 0;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 9; ++j)
      if ((x >> i & 1) && (m >> j & 1) && i + j >= 5) sum += 1 << (i + j - 5);
  return sum;
}

/// 11.3: the comparison for a decision axis.
inline bool ge(int axis, const vec3& corner, const vec3& dr) {
  const int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
  if (corner[b] < 0) return true;
  if (corner[a] < 0) return false;
  int ca = corner[a], cb = corner[b];
  for (int r = 0; r < 3 && (ca > 255 || cb > 255); ++r) ca >>= 1, cb >>= 1;
  const int ma = dr[a] < 0 ? -dr[a] - 1 : dr[a], mb = dr[b] < 0 ? -dr[b] - 1 : dr[b];
  return product(ca, mb) >= product(cb, ma);
}

template <class Unit>
struct Dut {
  Unit unit;
  UnitBench bench;
  std::function<Box(int)> scene = [](int) { return Box{{0, 0, 0}, {128, 256, 128}}; };

  std::function<int()> edges;  // what the scene tells of those of a face, once asked
  const bool several;          // portals in a face

  explicit Dut(const knobs& k = {})
      : unit("dut", k), bench(unit), several(k.portals_per_face > 1) {}

  int get(const char* port) { return bench[port].value(); }
  void set(const char* port, int value) { bench[port].drive(value); }
  vec3 corner() { return bench.read("corner"); }
  int depth() { return get("tag_o") >> LevelBits & low_bits(DepthBits); }
  int portal() { return get("tag_o") >> TagBits; }
  int level() { return get("tag_o") & 7; }
  At place() { return {depth(), level(), get("second_o")}; }
  bool bit() { return get("dec_o") & 1; }
  /// The scene answers for the room; outputs follow.
  void settle() {
    const Box box = scene(get("room_o"));
    bench.drive("position", "_i", box.centre);
    bench.drive("half_size", "_i", box.half);
    bench.settle();
    if (!edges) return;
    set("edges_i", edges());
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
  void ask_descend(int signs, bool bit, int neighbour = SolidRoom, int back = 0) {
    set("state_i", StateLeft);
    set("descend_i", 1);
    set("ray_signs_i", get("tag_o") == 2 ? ~signs : signs);  // 0.2 gets them with the decision
    set("cur_i", signs << 1 | int(bit));
    set("leave_i", level() == 7 || (several && bit && level() < 4) ? 2 | int(bit) : 0);
    set("neighbour_i", neighbour);
    set("back_i", back);
    settle();
  }
  void descend(int signs, bool bit, int neighbour = SolidRoom, int back = 0) {
    ask_descend(signs, bit, neighbour, back);
    clock();
  }
  void ask_climb(int target, int signs, int popped, int neighbour, int state = StateReturn,
                 int back = 0) {
    set("state_i", state);
    set("climb_i", 1);
    set("top_tag_i", target);
    set("ray_signs_i", signs);
    set("fread_i", popped);
    set("neighbour_i", neighbour);
    set("back_i", back);
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

/// Where the tracer is, told by geometry: the corner of a room, seen from the camera, mirrored.
struct Place {
  vec3 camera{};
  int signs = 0, level = 2;
  bool second = false;
  // By depth; faces: the face entered by; portals: of that face, and the one that leads back.
  std::vector<int> rooms, faces{0}, doms{0}, portals{0}, backs{0};

  int depth() const { return static_cast<int>(rooms.size()) - 1 - second; }
  int face() const { return faces[depth()]; }
  int new_face(bool bit) const { return doms[depth()] ? (bit ? 2 : 1) : (bit ? 0 : 2); }
  int code() const {
    const int d = depth();
    if (d == 0) return 0;
    return backs[d] << (FaceBits + PortalBits) | portals[d] << FaceBits | faces[d] | doms[d - 1];
  }

  /// Half way from room to room the corner stands at the camera.
  vec3 at_camera() const {
    vec3 c;
    for (int a = 0; a < 3; ++a)
      c[a] = wrap_signed(signs >> a & 1 ? camera[a] : -camera[a], CornerBits);
    return c;
  }

  vec3 corner(const std::function<Box(int)>& scene) const {
    if (second) return at_camera();
    const Box box = scene(rooms[depth()]);
    vec3 c;
    for (int a = 0; a < 3; ++a) {
      const int mirror = signs >> a & 1 ? -1 : 1;
      const bool far = level >= 6 || (level < 2 && a != face());
      if (level == 2 && depth() == 0) c[a] = box.centre[a] - camera[a];
      else c[a] = mirror * (box.centre[a] - camera[a]) + (far ? box.half[a] : -box.half[a]);
      c[a] = wrap_signed(c[a], CornerBits);
    }
    return c;
  }
};

template <class Unit>
class DecisionDatapathTest : public testing::Test {
 protected:
  Dut<Unit> dut;
};

using Twins = testing::Types<decision_datapath, own_rtl<decision_datapath>>;

/// From the root straight down through z faces, until `depth`.7.
template <class Unit>
void go_down(Dut<Unit>& d, int depth) {
  while (d.get("tag_o") != tag_of(depth, 7)) d.descend(0, false, d.level() == 7 ? 5 : SolidRoom);
}

}  // namespace racebeam
