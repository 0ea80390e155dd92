// camera_unit in its loop on the bench, and the result of a line in closed form.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "sc/camera_unit.h"
#include "sc/sequencer.h"
#include "tb/unit_bench.h"

namespace racebeam {

constexpr int mod(int v, int size) { return (v % size + size) % size; }
constexpr int floor_shift(int a, int k) { return (a - mod(a, 1 << k)) / (1 << k); }
constexpr int bit(int a, int n) { return mod(floor_shift(a, n), 2); }

/// Pixels of the next step from `from` to `to` (contract 9.5, its table).
inline int step_size(int from, int to) {
  const int n = 2 * (to - from), v = n >= 0 ? n : -n - 1;
  int log2 = 0;
  for (const int limit : {3, 6, 12, 24, 48, 96, 192, 384, 768}) log2 += v >= limit;
  return 1 << log2;
}

/// Steps from `from` to `to`: K of contract 7.6.
inline int K(int from, int to) {
  int steps = 0;
  for (; from != to; ++steps) from += from < to ? step_size(from, to) : -step_size(from, to);
  return steps;
}

/// What ray_stepper has added at pixel `i` (contract 8).
inline int J(int delta, int i) {
  int sum = 0;
  for (int k = 0; k <= 9; ++k)
    if (bit(i, k)) sum += floor_shift(delta * (1 << k), 9) + (k <= 8 ? bit(delta, 8 - k) : 0);
  return sum;
}

/// Camera of one line: yaw, pitch in 1/1024 turn and focal length.
struct View {
  int yaw, pitch, fov;
};

/// Contract 7.5 and 17.3, where the rotation is not fast.
inline View view_of(int frame, int variant, int y) {
  const int y9 = mod(y + 256, 512) - 256;
  const int yaw = frame / 4 + (variant == 1 || variant == 2 ? y9 : variant == 3 ? 2 * y9 : 0);
  const int pitch = 1023 - frame / 8 + (variant == 2 ? y9 : variant == 3 ? 2 * y9 : 0);
  const int fov = variant < 4 ? 96 : mod(frame / 2 + (variant >= 6 ? y9 : 0), 256);
  return {mod(yaw, 1024), mod(pitch, 1024), fov};
}

/// Result of a line: contract 7.1 in closed form, and the first clock of RUN by 7.6.
struct Line {
  vec3 dr_0, ddr;
  int first_run_clock;
};

inline Line expected_line(const View& view, int y) {
  const int t1 = 2 * view.yaw, u1 = t1 % 512, v1 = 511 - u1;
  const int t2 = 2 * view.pitch, u2 = t2 % 512, v2 = 511 - u2;
  static constexpr int yaw_offset[3][3] = {{0, 0, 1}, {2, 0, 3}, {1, 0, 2}};
  static constexpr int pitch_offset[2][3] = {{1, 0, 1}, {0, 1, 0}};
  static constexpr int start[3] = {0, 256, 512};
  const int target[3] = {view.fov, mod(y + 256, 512), 192};
  Line line{{}, {}, 0};
  for (int pass = 0; pass < 3; ++pass) {
    for (int a = 0; a < 3; ++a) {
      int q = t1 / 512 + yaw_offset[pass][a];
      bool negative = q & 2;
      int product = mod((q & 1 ? v1 : u1) + J(v1, u1), 1024);
      if (pass < 2 && a == 1) product = 511, negative = false;
      if (pass == 2 && a == 1) product = 0, negative = false;
      if (pass < 2) {
        q = t2 / 512 + pitch_offset[pass][a];
        negative ^= (q & 2) != 0;
        product = mod((q & 1 ? 0 : product) + J(product, v2), 1024);
        product = mod((q & 1 ? product : 0) + J(product, u2), 1024);
      }
      line.ddr[a] = wrap_signed(negative ? -product : product, 10);
      const int scaled = J(line.ddr[a], target[pass]) - J(line.ddr[a], start[pass]);
      line.dr_0[a] = wrap_signed(line.dr_0[a] + scaled, 10);
    }
    const int product = 4 + K(0, u1) + 3 + (pass < 2 ? K(0, v2) + 2 + K(0, u2) + 2 : 0);
    const int scale = K(start[pass], target[pass]);
    line.first_run_clock += product + 1 + (scale ? scale + 2 : K(0, u2) >= 3 ? 2 : 1);
  }
  return line;
}

/// The unit in a loop with plain stand-ins for ray_stepper (contract 8) and for what subdivider
/// does during tracer_reset (contract 9.4 to 9.7).
template <class Unit>
class CameraUnitKnobTest : public testing::Test {
 protected:
  void build(const knobs& k) {
    dr_bits = k.dr_bits;
    unit.emplace("dut", k);
    bench.emplace(*unit);
  }

  int out(const char* name) { return (*bench)[name].value(); }
  void drive(const char* name, int value) { (*bench)[name].drive(value); }

  void settle() {
    bench->drive("dr2", "_i", dr2);
    drive("y_i", y);
    drive("step_i", idx2 != i2);
    bench->settle();
    const int src = out("src_o");
    drive("angle_i", src == AngleYaw ? view.yaw : src == AnglePitch ? view.pitch : view.fov);
    bench->settle();
  }

  /// One clock of the loop.
  void clock() {
    settle();
    const vec3 delta = bench->read("delta"), old = dr2;
    const bool neg = i2 < idx2, step = idx2 != i2;
    const int size = step_size(idx2, i2), mask = out("axis_mask_o");
    for (int a = 0; a < 3; ++a) {
      if (out("load_o")) {
        dr2[a] = out("load_zero_o") ? 0 : dr1[a];
      } else if (out("ext_o")) {
        if (bit(mask, a)) dr2[a] += bit(out("ext_sign_o"), a) ? -delta[a] : delta[a];
      } else if (step && bit(mask, a)) {
        int b = 0;
        while (b < 10 && (1 << b < size || bit(idx2, b) != neg)) ++b;
        const int e = b <= 8 ? bit(delta[a], 8 - b) : 0;
        dr2[a] += (neg ? -1 : 1) * (floor_shift(delta[a] * size, 9) + e);
      }
      dr2[a] = wrap_signed(dr2[a], dr_bits);
    }
    if (out("copy_ext_o")) dr1 = old;
    if (out("idx_load_o")) idx2 = out("idx_start_o");
    else if (step) idx2 = mod(neg ? idx2 - size : idx2 + size, 1024);
    i2 = out("i2_init_o");
    bench->clock();
    settle();
  }

  /// Starts a line: c = 0 after this.
  void start_line(const View& of_line, int of_y) {
    drive("rst_ni", 1);
    drive("line_end_i", 1);
    clock();
    drive("line_end_i", 0);
    view = of_line;
    y = of_y;
    settle();
  }

  /// To the first clock of RUN; returns its c.
  int run_line(const View& of_line, int of_y) {
    start_line(of_line, of_y);
    int c = 0;
    for (; !out("run_o") && c < 1600; ++c) {
      EXPECT_EQ(out("tracer_reset_o"), 1) << c;
      clock();
    }
    EXPECT_EQ(out("tracer_reset_o"), 0);
    return c;
  }

  void check_line(const View& of_line, int of_y) {
    const Line want = expected_line(of_line, of_y);
    ASSERT_EQ(run_line(of_line, of_y), want.first_run_clock);
    ASSERT_EQ(dr1, want.dr_0);
    ASSERT_EQ(dr2, want.dr_0);
    ASSERT_EQ(bench->read("delta"), want.ddr);
    ASSERT_EQ(idx2, 0);
    ASSERT_EQ(i2, 639);
  }

  /// Lines at another width of dr against the closed form for 10 bits, in the units of that width.
  void check_scale(int bits, int tolerance) {
    knobs k;
    k.dr_bits = bits;
    build(k);
    const double scale = std::ldexp(1.0, bits - 10);
    for (int frame = 0; frame < 4096; frame += 31) {
      const int line = frame % 480 - 240;
      const Line want = expected_line(view_of(frame, 0, line), line);
      ASSERT_EQ(run_line(view_of(frame, 0, line), line), want.first_run_clock) << frame;
      for (int a = 0; a < 3; ++a) {
        ASSERT_NEAR(dr2[a], want.dr_0[a] * scale, tolerance) << frame << " axis " << a;
        ASSERT_NEAR(bench->read("delta")[a], want.ddr[a] * scale, tolerance)
            << frame << " axis " << a;
      }
    }
  }

  int dr_bits = 10;
  View view{0, 0, 96};
  int y = 0;
  vec3 dr1{}, dr2{};
  int idx2 = 0, i2 = 0;
  std::optional<Unit> unit;
  std::optional<UnitBench> bench;
};

template <class Unit>
class CameraUnitTest : public CameraUnitKnobTest<Unit> {
 protected:
  CameraUnitTest() { this->build({}); }
};

using Twins = testing::Types<camera_unit>;

}  // namespace racebeam
