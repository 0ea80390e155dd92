// Behaviour of block_shade (block_shade.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/fixed_point.h"
#include "sc/block/knobs.h"
#include "sc/block/numbers.h"

namespace racebeam {

struct block_shade_core {
  enum step {
    Point = 0,  // idle, too
    Normal = 1,
    Light = 2,
    Diffuse = 3,
    Twice = 4,
    Away = 5,
    Specular = 6,
    Square = 7,
    Colour = 8,
    Along = 9,
    Double = 10,
    Last = 11
  };
  int step_q = Point;
  int square_q = 0;  // squarings that are over
  vec3 point_q{}, normal_q{}, lit_q{}, colour_q{};
  int diffuse_q = 0, twice_q = 0, s_q = 0;

  struct inputs {
    bool rst_n, start;
    vec3 position, dir;
    int distance;
    vec3 centre, light, base;
    vec3 unit;
    bool unit_done;
  };

  bool done() const { return step_q == Last; }
  bool normalise() const { return step_q == Normal || step_q == Light; }
  vec3 vector(const inputs& in) const {
    return step_q == Normal ? block_difference(point_q, in.centre)
                            : block_difference(in.light, point_q);
  }
  vec3 direction(const inputs& in) const {
    if (!done()) return {};
    return block_difference(in.dir, imul(normal_q, twice_q));
  }

  void clock(const inputs& in, const block_knobs& k) {
    const int next = next_step(in, k);
    switch (step_q) {
      case Point:
        if (in.start) point_q = block_sum(in.position, imul(in.dir, in.distance));
        break;
      case Normal: normal_q = in.unit; break;
      case Light: lit_q = in.unit; break;
      case Diffuse: diffuse_q = not_below_0(idot(normal_q, lit_q)); break;
      case Twice: twice_q = block_sum(diffuse_q, diffuse_q); break;
      case Away: lit_q = block_difference(lit_q, imul(normal_q, twice_q)); break;
      case Specular:
        s_q = not_below_0(idot(in.dir, lit_q));
        square_q = 0;
        break;
      case Square:
        s_q = imul(s_q, s_q);
        square_q = (square_q + 1) & 7;
        break;
      case Colour: colour_q = block_sum(imul(in.base, diffuse_q), {s_q, s_q, s_q}); break;
      case Along: twice_q = idot(normal_q, in.dir); break;
      case Double: twice_q = block_sum(twice_q, twice_q); break;
      default: break;
    }
    step_q = in.rst_n ? next : Point;
  }

  /// Calls visit(name, bits, read) for each register; the RTL has three axes in one.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("step_q", 4, [this] { return step_q; });
    visit("square_q", 3, [this] { return square_q; });
    for (int n = 0; n < 3; ++n) {
      const std::string axis = std::string(1, "xyz"[n]) + "_q";
      visit("point_" + axis, BlockBits, [this, n] { return point_q[n]; });
      visit("normal_" + axis, BlockBits, [this, n] { return normal_q[n]; });
      visit("lit_" + axis, BlockBits, [this, n] { return lit_q[n]; });
    }
    visit("colour_red_q", BlockBits, [this] { return colour_q[0]; });
    visit("colour_green_q", BlockBits, [this] { return colour_q[1]; });
    visit("colour_blue_q", BlockBits, [this] { return colour_q[2]; });
    visit("diffuse_q", BlockBits, [this] { return diffuse_q; });
    visit("twice_q", BlockBits, [this] { return twice_q; });
    visit("s_q", BlockBits, [this] { return s_q; });
  }

 private:
  int next_step(const inputs& in, const block_knobs& k) const {
    switch (step_q) {
      case Point: return in.start ? Normal : Point;
      case Normal:
      case Light: return in.unit_done ? step_q + 1 : step_q;
      case Specular: return k.specular_squarings == 0 ? Colour : Square;
      case Square: return square_q + 1 < k.specular_squarings ? Square : Colour;
      case Last: return Point;
      default: return step_q + 1;
    }
  }
};

}  // namespace racebeam
