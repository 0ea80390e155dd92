// navigator as a scene file asks for it, among rooms with several portals in a face.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "tests/beam/navigator_bench.h"

namespace racebeam {

inline constexpr int Hub = 5000;
inline constexpr vec3 HubCentre{300, -200, 500};
inline constexpr int HubHalf = 100;

/// Behind each face of a cube stand three rooms side by side, beyond each of them solid rock.
/// Room 10 * face + place is at low, middle or high coordinates of the next axis.
struct ThreeBehindEachFace {
  vec3 velocity{};
  std::vector<int> order{0, 1, 2};  // place by portal

  struct Span {
    int low, high;
  };
  static constexpr Span spans[3] = {{-100, -40}, {-40, 40}, {40, 100}};
  static constexpr int Depth = 30;

  static int across(int face) { return (face / 2 + 1) % 3; }
  /// In the first clocks the unit may ask for any room.
  static bool is_behind_a_face(int room) { return room < 60 && room % 10 < 3; }
  vec3 half_size(int room) const {
    vec3 half{HubHalf, HubHalf, HubHalf};
    if (room == Hub) return half;
    if (!is_behind_a_face(room)) return {};
    const Span& s = spans[room % 10];
    half[room / 10 / 2] = Depth;
    half[across(room / 10)] = (s.high - s.low) / 2;
    return half;
  }
  vec3 position(int room) const {
    vec3 centre = HubCentre;
    if (room == Hub) return centre;
    if (!is_behind_a_face(room)) return {};
    const Span& s = spans[room % 10];
    const int face = room / 10;
    centre[face / 2] += (face % 2 ? -1 : 1) * (HubHalf + Depth);
    centre[across(face)] += (s.high + s.low) / 2;
    return centre;
  }
  int neighbour(int room, int axis, bool negative, int portal) const {
    const int face = 2 * axis + negative;
    if (room == Hub)
      return portal < static_cast<int>(order.size()) ? 10 * face + order[portal] : SolidRoom;
    return portal == 0 && is_behind_a_face(room) && face == (room / 10 ^ 1) ? Hub : SolidRoom;
  }
};

template <class Unit, int Portals>
class FreeFlight : public NavigatorBench<Unit, ThreeBehindEachFace> {
 protected:
  static knobs free(int portals) {
    knobs k;
    k.free_flight = true;
    k.navigator_bits = 11;
    k.corner_bits = 14;
    k.portals_per_face = portals;
    return k;
  }
  FreeFlight() : NavigatorBench<Unit, ThreeBehindEachFace>(free(Portals)) {}

  /// The camera at rest at a place in the hub.
  void place(const vec3& camera) {
    for (int a = 0; a < 3; ++a) start[a] = -camera[a];
    this->bench.drive("start", "_i", start);
    this->bench["start_room_i"].drive(Hub);
    this->bench["nav_reset_i"].drive(1);
    this->bench.clock();
    this->bench["nav_reset_i"].drive(0);
  }
  /// The nav_line from there; clocks from the first one after active_start to the last that acts.
  int fly() {
    this->start_nav_line();
    int last = 0;
    for (int n = 1; n <= 60; ++n) {
      const bool acts = this->out("nav_op_o") != CornerHold;
      const vec3 before = this->position();
      const int room = this->out("nav_room_o");
      this->clock();
      if (acts || this->position() != before || this->out("nav_room_o") != room) last = n;
    }
    this->bench["nav_line_i"].drive(0);
    this->bench.clock();
    return last;
  }
  /// Places the camera inside a face, `at` along the axis across, and flies it out.
  int leave(int face, int at) {
    vec3 camera{7, -9, 11};
    const int axis = face / 2, out = face % 2 ? -1 : 1;
    camera[axis] = out * 97;
    camera[ThreeBehindEachFace::across(face)] = at;
    this->world.velocity = {};
    this->world.velocity[axis] = -5 * out;
    place(camera);
    return fly();
  }
  void expect_in(int room) {
    ASSERT_EQ(this->out("nav_room_o"), room);
    const vec3 to = this->world.position(room);
    for (int a = 0; a < 3; ++a)
      ASSERT_EQ(this->position()[a], start[a] + this->world.velocity[a] + to[a] - HubCentre[a])
          << "axis " << a;
  }

  vec3 start{};
};

}  // namespace racebeam
