// Behaviour of block_convert (block_convert.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/base/fixed_point.h"
#include "sc/block/knobs.h"
#include "sc/block/numbers.h"

namespace racebeam {

struct block_convert_core {
  int step_q = 0;  // 1..3: the clocks after a sphere's last number
  int index_q = 0;
  vec3 eye_q{}, light_q{}, pose_q{};
  int width_q = 0, height_q = 0;  // of the screen
  int radius_q = 0, radius2_q = 0, norm2_q = 0;

  struct inputs {
    bool rst_n, valid;
    std::uint32_t number;  // a float's bits
    int field, index;
  };
  struct outputs {
    bool ready, write;
    int field, index, fixed, eye_k;
  };

  static int fixed(const inputs& in, const block_knobs& k) {
    return f2i(float_of_bits(in.number)) & ~low_bits(BlockFraction - k.fraction_bits);
  }
  int eye_k(int field) const {
    return field <= BlockCentreZ ? eye_q[static_cast<std::size_t>(field)] : 0;
  }
  outputs comb(const inputs& in, const block_knobs& k) const {
    if (step_q == 1)
      return {false, true, BlockRadius2, index_q, imul(radius_q, radius_q), eye_k(in.field)};
    if (step_q >= 2)
      return {false,          step_q == 3, BlockRv, index_q, block_difference(radius2_q, norm2_q),
              eye_k(in.field)};
    return {true,           in.valid && in.field < BlockRv, in.field, in.index, fixed(in, k),
            eye_k(in.field)};
  }
  vec3 start() const {
    return {block_difference(wrap32(-std::int64_t{width_q}) >> 1, eye_q[0]),
            block_difference(height_q >> 1, eye_q[1]), block_difference(0, eye_q[2])};
  }
  /// A clock with these inputs changes nothing.
  bool idle(const inputs& in) const { return in.rst_n && !in.valid && step_q == 0; }
  void clock(const inputs& in, const block_knobs& k) {
    if (step_q == 1) radius2_q = imul(radius_q, radius_q);
    else if (step_q == 2) norm2_q = inorm2(pose_q);
    if (step_q != 0) step_q = (step_q + 1) & 3;
    else if (in.valid) take(in, k);
    if (in.rst_n) return;
    step_q = 0;
    eye_q = light_q = {};
    width_q = height_q = 0;
  }

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("step_q", 2, [this] { return step_q; });
    visit("index_q", BlockIndexBits, [this] { return index_q; });
    visit("radius_q", BlockBits, [this] { return radius_q; });
    visit("radius2_q", BlockBits, [this] { return radius2_q; });
    visit("norm2_q", BlockBits, [this] { return norm2_q; });
    visit("width_q", BlockBits, [this] { return width_q; });
    visit("height_q", BlockBits, [this] { return height_q; });
  }

 private:
  void take(const inputs& in, const block_knobs& k) {
    const int value = fixed(in, k);
    const auto axis = static_cast<std::size_t>(in.field);
    index_q = in.index;
    if (in.field <= BlockCentreZ) pose_q[axis] = block_difference(eye_q[axis], value);
    else if (in.field == BlockRadius) radius_q = value;
    else if (in.field >= BlockEyeX && in.field <= BlockEyeZ) eye_q[axis - BlockEyeX] = value;
    else if (in.field >= BlockLightX && in.field <= BlockLightZ)
      light_q[axis - BlockLightX] = value;
    else if (in.field == BlockScreenWidth) width_q = value;
    else if (in.field == BlockScreenHeight) height_q = value;
    if (in.field == BlockBlue) step_q = 1;
  }
};

}  // namespace racebeam
