// Behaviour of vector_unit (vector_unit.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/sphere/numbers.h"

namespace racebeam {

struct vector_unit_core {
  struct inputs {
    int op;
    vec3 a, b;
    int s;
  };
  struct outputs {
    vec3 product;
    std::int64_t sum, square;
  };
  static outputs comb(const inputs& in) {
    outputs o{};
    for (int k = 0; k < 3; ++k) {
      const int left = in.op == VectorDot || in.op == VectorScale ? in.a[k] : in.s;
      const int right = in.op == VectorDot ? in.b[k] : in.s;
      const std::int64_t lane = static_cast<std::int64_t>(left) * right;
      o.product[k] = floor24(lane);
      o.sum += lane;
      if (k == 0) o.square = wrap48(lane);
    }
    o.sum = wrap48(o.sum);
    return o;
  }
};

}  // namespace racebeam
