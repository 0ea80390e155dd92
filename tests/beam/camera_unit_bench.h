// camera_unit in its loop on the bench, and what a line must come to.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "sc/beam/camera_unit.h"
#include "sc/beam/sequencer.h"
#include "tb/golden/golden_camera.h"
#include "tb/twin/unit_bench.h"
#include "tests/support/own_rtl.h"

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

using View = GoldenView;

/// The view of a line where the rotation is not fast.
inline View view_of(int frame, int variant, int y) { return golden_view(frame, variant, false, y); }

/// Result of a line in closed form, and the first clock of RUN by contract 7.6.
struct Line {
  vec3 dr_0, ddr;
  int first_run_clock;
};

inline Line expected_line(const View& view, int y, int cosine = CosineParabola) {
  const GoldenLine golden = golden_line(view, y, cosine);
  Line line{golden.dr_0, golden.ddr, 0};
  const int u1 = view.yaw % 512, u2 = view.pitch % 512, v2 = 511 - u2;
  const int start[3] = {0, 256, 512}, target[3] = {view.fov, mod(y + 256, 512), 192};
  for (int pass = 0; pass < 3; ++pass) {
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
    check_line(of_line, of_y, expected_line(of_line, of_y));
  }
  void check_line(const View& of_line, int of_y, const Line& want) {
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

  /// Lines with a shorter head start; the last time one line is left before its tracer begins.
  void check_head_start(int wait) {
    knobs k;
    k.head_start = wait;
    build(k);
    for (const int line : {-240, 0, 239}) {
      const View of_line = view_of(700, 0, line);
      Line want = expected_line(of_line, line);
      want.first_run_clock += wait;
      check_line(of_line, line, want);
      start_line(of_line, line);
      for (int c = 0; c < want.first_run_clock - 1; ++c) clock();
      check_line(of_line, line, want);
      if (this->HasFatalFailure()) return;
    }
  }

  void check_ddr_fraction(int bits) {
    knobs k;
    k.ddr_fraction_bits = bits;
    build(k);
    for (const int line : {-240, 0, 239}) {
      const View of_line = view_of(700, 0, line);
      const Line whole = expected_line(of_line, line);
      EXPECT_EQ(run_line(of_line, line), whole.first_run_clock);
      const vec3 ddr = bench->read("delta");
      for (int a = 0; a < 3; ++a) {
        EXPECT_EQ(ddr[a], floor_shift(whole.ddr[a], 9 - bits) * (1 << (9 - bits)));
        const int left_out = whole.ddr[a] - ddr[a];
        EXPECT_NEAR(dr2[a], whole.dr_0[a] + 320 * left_out / 512.0, 3) << "axis " << a;
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

using Twins = testing::Types<camera_unit, own_rtl<camera_unit>>;

}  // namespace racebeam
