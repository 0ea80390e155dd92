// navigator on the bench, with rooms and decision_datapath's corner around it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include "sc/beam/navigator.h"
#include "tb/twin/unit_bench.h"
#include "tests/support/own_rtl.h"

namespace racebeam {

inline constexpr int TX[8] = {0, -2, -3, -2, 0, 2, 3, 2};
inline constexpr int TY[8] = {3, 2, 0, -2, -3, -2, 0, 2};

constexpr int wrap12(int v) { return (v % 4096 + 4096 + 2048) % 4096 - 2048; }
constexpr int mod(int v, int size) { return (v % size + size) % size; }

/// The rooms that a flight passes (contract 17.2; k = 0, i = 4 unless an x face is passed).
struct World {
  bool tunnel = false, narrow = false;
  int start_y = -224;
  vec3 velocity{0, 0, -1};

  int half_z(int j) const { return narrow ? (j % 2 ? 176 : 80) : 128; }
  vec3 half_size(int room) const {
    return {tunnel ? 256 : narrow ? 80 : 128, 256, half_z(room >> 4 & 15)};
  }
  vec3 position(int room) const {
    const int i = room & 15, j = room >> 4 & 15;
    if (tunnel) return {64 * TX[j % 8], 64 * TY[j % 8], 256 * j};
    return {256 * i, 0, 256 * j};
  }
  int neighbour(int room, int axis, bool negative, int /*portal*/) const {
    const int d = negative ? -1 : 1;
    if (axis == 0) return (room & ~15) | mod(room + d, 16);
    if (axis == 2) return (room & 15) | mod((room >> 4) + d, 16) << 4;
    return 511;
  }
};

/// The unit among `Rooms`, which answer half_size, position and neighbour and have a velocity.
template <class Unit, class Rooms>
class NavigatorBench : public testing::Test {
 protected:
  explicit NavigatorBench(const knobs& k = {}) : fitted(k), unit("dut", k), bench(unit) {
    bench.clock(2);
    bench["rst_ni"].drive(1);
    bench.settle();
  }

  vec3 position() { return bench.read("nav_position"); }
  int room_j() { return out("nav_room_o") >> 4 & 15; }
  int out(const char* name) { return bench[name].value(); }

  void show_corner() {
    bench.drive("corner", "_i", corner);
    bench["room_i"].drive(room);
    bench.settle();
  }

  /// One clock of the nav_line: what decision_datapath does with the navigator's controls.
  void clock(bool active_start = false) {
    bench["active_start_i"].drive(active_start);
    show_corner();
    const vec3 s = world.half_size(room), r = world.position(room);
    const int op = out("nav_op_o");
    vec3 next = corner;
    for (int a = 0; a < 3; ++a) {
      switch (op) {
        case CornerAddVelocity: next[a] += world.velocity[a]; break;
        case CornerAddS: next[a] += s[a]; break;
        case CornerSubtract2S: next[a] -= 2 * s[a]; break;
        case CornerLeavePlus: next[a] -= r[a] + s[a]; break;
        case CornerLeaveMinus: next[a] += s[a] - r[a]; break;
        case CornerAddR: next[a] += r[a]; break;
        default: break;
      }
      next[a] = wrap_signed(next[a], fitted.corner_bits);
    }
    if (out("nav_move_o"))
      room = world.neighbour(room, out("nav_axis_o"), out("nav_negative_o"), out("nav_portal_o"));
    if (active_start || op == CornerCamera) {  // the tree is re-rooted (contract 11.1)
      next = position();
      room = out("nav_room_o");
    }
    bench.clock();
    corner = next;
    bench["active_start_i"].drive(0);
    show_corner();
  }

  /// Up to the first clock after active_start of the last line of a frame (c = 320).
  void start_nav_line() {
    bench["nav_line_i"].drive(1);
    clock();
    clock(true);
  }

  void frame(bool nav_reset) {
    bench["nav_reset_i"].drive(nav_reset);
    bench.clock(2);
    bench["active_start_i"].drive(1);  // of the other lines
    bench.clock();
    bench["active_start_i"].drive(0);
    bench.clock(2);
    start_nav_line();
    for (int n = 0; n < 8; ++n) clock();
    bench["nav_line_i"].drive(0);
    bench.clock();
  }

  Rooms world;
  vec3 corner{};
  int room = 4;
  const knobs fitted;
  Unit unit;
  UnitBench bench;
};

/// On the chip's own flights.
template <class Unit>
class NavigatorTest : public NavigatorBench<Unit, World> {
 protected:
  NavigatorTest() {
    this->bench.drive("start", "_i", {0, this->world.start_y, 0});
    this->bench["start_room_i"].drive(4);
    this->bench.settle();
  }

  /// A flight of `frames` frames against contract 17.6 (13.1 for the pillars).
  void fly(int frames, int velocity_z) {
    this->world.velocity = {0, 0, velocity_z};
    this->bench.drive("start", "_i", {0, this->world.start_y, 0});
    this->bench["start_room_i"].drive(4);
    int j = 0;  // counts on, where the tunnel's room number wraps
    for (int h = 0; h < frames; ++h) {
      if (h == 0) {
        this->bench["nav_reset_i"].drive(1);
        this->bench.clock();
      }
      const int g = h == 0 ? 0 : -velocity_z * (h - 1);
      if (256 * j - g < -this->world.half_z(j)) ++j;
      const int x = this->world.tunnel ? 64 * (TX[j % 8] - TX[0]) : 0;
      const int y = this->world.start_y + (this->world.tunnel ? 64 * (TY[j % 8] - TY[0]) : 0);
      ASSERT_EQ(this->position(), (vec3{x, y, 256 * j - g})) << "frame " << h;
      ASSERT_EQ(this->out("nav_room_o"), j % 16 << 4 | 4) << "frame " << h;
      this->frame(h == 0);
    }
  }
};

using Twins = testing::Types<navigator, own_rtl<navigator>>;

}  // namespace racebeam
