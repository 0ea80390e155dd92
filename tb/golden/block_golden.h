// block_golden: the picture that the block renderer means, in double precision.
//
// The same rules with exact roots and unit vectors; it shares no code with sc/, only what the host
// sends. A reflected ray does not meet the sphere that it starts from, and no block is cleared.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "sc/block/block_world.h"

namespace racebeam {

class BlockGolden {
 public:
  BlockGolden(const block_knobs& k, const block_tables& tables) : knobs_(k), tables_(tables) {}

  /// Channels of 0..255, not rounded.
  std::array<double, 3> pixel(int x, int y) const;
  /// The sphere that a pixel's ray meets first; -1: none.
  int first_hit(int x, int y) const;

 private:
  using Vector = std::array<double, 3>;
  struct Ray {
    Vector from, way;  // of length 1
    int own;           // the sphere that it starts from
  };
  struct Hit {
    int sphere;
    double t;
  };
  Ray primary(int x, int y) const;
  Hit nearest(const Ray& ray) const;
  /// The light of what it met; the ray goes on from there.
  Vector shade(Ray& ray, const Hit& hit) const;

  const block_knobs knobs_;
  const block_tables tables_;
};

}  // namespace racebeam
