// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/camera_unit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>

#include "sc/sequencer.h"
#include "tb/unit_bench.h"

namespace racebeam {
namespace {

constexpr int mod(int v, int size) { return (v % size + size) % size; }
constexpr int floor_shift(int a, int k) { return (a - mod(a, 1 << k)) / (1 << k); }
constexpr int bit(int a, int n) { return mod(floor_shift(a, n), 2); }

/// Pixels of the next step from `from` to `to` (contract 9.5, its table).
int step_size(int from, int to) {
  const int n = 2 * (to - from), v = n >= 0 ? n : -n - 1;
  int log2 = 0;
  for (const int limit : {3, 6, 12, 24, 48, 96, 192, 384, 768}) log2 += v >= limit;
  return 1 << log2;
}

/// Steps from `from` to `to`: K of contract 7.6.
int K(int from, int to) {
  int steps = 0;
  for (; from != to; ++steps) from += from < to ? step_size(from, to) : -step_size(from, to);
  return steps;
}

/// What ray_stepper has added at pixel `i` (contract 8).
int J(int delta, int i) {
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
View view_of(int frame, int variant, int y) {
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
Line expected_line(const View& view, int y) {
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
    drive("stepping_i", idx2 != i2);
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
    if (out("copy_o")) dr1 = old;
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
TYPED_TEST_SUITE(CameraUnitTest, Twins);
TYPED_TEST_SUITE(CameraUnitKnobTest, Twins);

// Contract 7.7: frame 2, y = -240.
TYPED_TEST(CameraUnitTest, LineFollowsTheMicroTrace) {
  struct Row {
    int c, idx2, i2;
    std::optional<vec3> dr2, dr1, ddr;  // ddr is on the delta pins from pstage 1 on
  };
  using V = vec3;
  const std::optional<vec3> _;
  const Row rows[] = {
      {0, 0, 0, V{0, 0, 0}, _, _},
      {1, 0, 0, V{0, 0, 0}, _, _},
      {2, 0, 0, V{0, 0, 511}, _, _},
      {3, 0, 0, V{0, 511, 511}, _, _},
      {4, 0, 0, V{0, 0, 0}, _, V{0, 511, 511}},
      {5, 0, 1, V{0, 0, 511}, _, V{0, 511, 511}},
      {6, 1, 1, V{0, 1, -512}, _, V{0, 511, 511}},  // 512 in 10 bits
      {7, 0, 0, V{0, 0, 0}, _, V{0, 1, 512}},
      {8, 0, 510, V{0, 1, 0}, _, _},
      {9, 512, 510, V{0, 2, -512}, _, _},
      {10, 510, 510, V{0, 2, 510}, _, _},
      {11, 0, 0, V{0, 0, 0}, _, V{0, 2, 510}},
      {12, 0, 510, V{0, -2, 510}, _, V{0, 2, 510}},
      {13, 512, 510, V{0, -4, -4}, _, V{0, -2, 510}},
      {14, 510, 510, _, _, V{0, -2, 510}},
      {15, 0, 96, V{0, 0, 0}, _, _},
      {16, 128, 96, V{0, 0, 128}, _, _},
      {17, 96, 96, V{0, 0, 96}, _, _},
      {18, 96, 96, V{0, 0, 96}, _, _},
      {19, 0, 0, V{0, 0, 0}, V{0, 0, 96}, _},
      {30, 0, 0, V{0, 0, 0}, V{0, 0, 96}, V{0, 510, 2}},
      {34, 256, 16, V{0, 0, 96}, V{0, 0, 96}, V{0, 510, 2}},
      {35, 0, 16, V{0, -255, 95}, _, _},
      {36, 16, 16, V{0, -239, 95}, _, _},
      {38, 0, 0, V{0, 0, 0}, V{0, -239, 95}, _},
      {42, 0, 0, V{0, 0, 0}, _, V{511, 0, 0}},
      {46, 512, 192, V{0, -239, 95}, V{0, -239, 95}, V{511, 0, 0}},
      {47, 256, 192, V{-255, -239, 95}, _, _},
      {48, 192, 192, V{-319, -239, 95}, _, _},
      {49, 192, 192, V{-319, -239, 95}, _, _},
      {50, 0, 639, V{-319, -239, 95}, V{-319, -239, 95}, V{511, 0, 0}},
  };
  this->start_line(view_of(2, 0, -240), -240);
  int c = 0;
  for (const Row& row : rows) {
    for (; c < row.c; ++c) {
      ASSERT_EQ(this->out("run_o"), 0);
      this->clock();
    }
    SCOPED_TRACE(c);
    EXPECT_EQ(this->idx2, row.idx2);
    EXPECT_EQ(this->i2, row.i2);
    EXPECT_EQ(this->dr2, row.dr2.value_or(this->dr2));
    EXPECT_EQ(this->dr1, row.dr1.value_or(this->dr1));
    const vec3 delta = this->bench->read("delta");
    EXPECT_EQ(delta, row.ddr.value_or(delta));
  }
  EXPECT_EQ(this->out("run_o"), 1);
}

// Contract 7.3 and 7.4: the controls of the first pass of that line, worked out by hand.
TYPED_TEST(CameraUnitTest, ControlsFollowTheTablesOfTheProductAndThePhases) {
  struct Row {
    int src, load, ext, ext_sign, axis_mask, copy, idx_load, i2_init;
  };
  const Row rows[] = {
      {0, 0, 1, 0, 1, 0, 0, 0},  // c = 0: + frac for sine axes
      {0, 0, 1, 0, 4, 0, 0, 0},  // + inv for cosine axes
      {0, 0, 1, 0, 2, 0, 0, 0},  // + 511 for ONE
      {0, 1, 0, 0, 5, 0, 1, 0},  // frac = 0: done at once
      {1, 0, 1, 0, 5, 0, 0, 1},  // pitch: + ddr for sine axes
      {1, 0, 0, 0, 7, 0, 0, 1},   {1, 1, 0, 0, 7, 0, 1, 0},
      {1, 0, 1, 0, 2, 0, 0, 510},  // + ddr for cosine axes
      {1, 0, 0, 0, 7, 0, 0, 510}, {1, 0, 0, 0, 7, 0, 0, 510},
      {1, 1, 0, 0, 7, 0, 1, 0},   {1, 0, 1, 2, 7, 0, 0, 510},  // sign: y is negative
      {1, 0, 1, 2, 7, 0, 0, 510}, {1, 0, 1, 2, 7, 0, 0, 510},
      {2, 1, 0, 0, 7, 0, 1, 96},  // LOAD
      {2, 0, 0, 0, 7, 0, 0, 96},  // SCALE
      {2, 0, 0, 0, 7, 0, 0, 96},  {2, 0, 0, 0, 7, 0, 0, 96},
      {1, 1, 1, 2, 7, 1, 1, 0},  // finish: preset of the next pass
      {0, 0, 1, 0, 1, 0, 0, 0},  // pass 1: yaw offsets 2, -, 3: x is sine
  };
  this->start_line(view_of(2, 0, -240), -240);
  int c = 0;
  for (const Row& row : rows) {
    SCOPED_TRACE(c++);
    EXPECT_EQ(this->out("src_o"), row.src);
    EXPECT_EQ(this->out("load_o"), row.load);
    EXPECT_EQ(this->out("copy_o"), row.copy);
    EXPECT_EQ(this->out("idx_load_o"), row.idx_load);
    EXPECT_EQ(this->out("i2_init_o"), row.i2_init);
    if (row.load) {  // what the stepper does not look at in this clock is free
      EXPECT_EQ(this->out("load_zero_o"), 1);
      EXPECT_EQ(this->out("idx_start_o"), 0);
    } else {
      EXPECT_EQ(this->out("ext_o"), row.ext);
      EXPECT_EQ(this->out("axis_mask_o"), row.axis_mask);
      EXPECT_EQ(row.ext ? this->out("ext_sign_o") : 0, row.ext_sign);
    }
    this->clock();
  }
  while (!(this->out("copy_o") && this->out("i2_init_o") == 639) && c++ < 100) this->clock();
  EXPECT_EQ(this->out("load_o"), 0);  // the last finish keeps dr2
  EXPECT_EQ(this->out("idx_load_o"), 1);
  EXPECT_EQ(this->out("idx_start_o"), 0);
  EXPECT_EQ(this->out("run_o"), 0);
  this->clock();
  EXPECT_EQ(this->out("run_o"), 1);
}

// Contract 20.1.
TYPED_TEST(CameraUnitTest, LinesGiveTheVectorsOfTheContract) {
  struct Row {
    int frame, y, c;
    vec3 dr_0, ddr;
  };
  const Row rows[] = {
      {2, -240, 50, {-319, -239, 95}, {511, 0, 0}},
      {2, -239, 51, {-319, -238, 95}, {511, 0, 0}},
      {2, -100, 51, {-319, -99, 96}, {511, 0, 0}},
      {2, 0, 47, {-319, 0, 96}, {511, 0, 0}},
      {2, 100, 51, {-319, 100, 96}, {511, 0, 0}},
      {2, 239, 51, {-319, 239, 97}, {511, 0, 0}},
      {700, -240, 70, {-217, -265, 260}, {272, 0, -461}},
      {700, -239, 71, {-216, -264, 260}, {272, 0, -461}},
      {700, -100, 71, {-145, -141, 302}, {272, 0, -461}},
      {700, 0, 68, {-94, -54, 333}, {272, 0, -461}},
      {700, 100, 71, {-43, 34, 363}, {272, 0, -461}},
      {700, 239, 71, {29, 157, 405}, {272, 0, -461}},
      {1400, -240, 65, {49, -214, 376}, {-307, 0, -442}},
      {1400, -239, 66, {50, -213, 375}, {-307, 0, -442}},
      {1400, -100, 66, {158, -140, 301}, {-307, 0, -442}},
      {1400, 0, 62, {236, -87, 247}, {-307, 0, -442}},
      {1400, 100, 66, {314, -34, 193}, {-307, 0, -442}},
      {1400, 239, 66, {423, 40, 118}, {-307, 0, -442}},
      {4700, -240, 72, {-181, 265, 288}, {333, 0, -426}},
      {4700, -239, 73, {-181, 264, 288}, {333, 0, -426}},
      {4700, -100, 73, {-240, 138, 242}, {333, 0, -426}},
      {4700, 0, 70, {-281, 48, 210}, {333, 0, -426}},
      {4700, 100, 73, {-323, -43, 178}, {333, 0, -426}},
      {4700, 239, 73, {-381, -169, 132}, {333, 0, -426}},
      {8754, -240, 70, {-284, -240, 200}, {358, 0, -407}},
      {8754, -239, 71, {-284, -240, 200}, {358, 0, -407}},
      {8754, -100, 73, {-128, -178, 338}, {358, 0, -407}},
      {8754, 0, 68, {-204, -12, 270}, {358, 0, -407}},
      {8754, 100, 71, {-93, 34, 369}, {358, 0, -407}},
      {8754, 239, 69, {-127, 217, 340}, {358, 0, -407}},
      {9100, -240, 72, {-74, -328, 313}, {107, 0, -504}},
      {9100, -239, 73, {-73, -327, 313}, {107, 0, -504}},
      {9100, -100, 73, {21, -216, 333}, {107, 0, -504}},
      {9100, 0, 70, {90, -136, 348}, {107, 0, -504}},
      {9100, 100, 73, {159, -56, 363}, {107, 0, -504}},
      {9100, 239, 73, {253, 56, 382}, {107, 0, -504}},
  };
  for (const Row& row : rows) {
    const int variant = row.frame == 8754 ? 6 : row.frame == 9100 ? 5 : 0;
    SCOPED_TRACE(testing::Message() << "frame " << row.frame << ", y = " << row.y);
    const View view = view_of(row.frame, variant, row.y);
    EXPECT_EQ(this->run_line(view, row.y), row.c);
    EXPECT_EQ(this->dr1, row.dr_0);
    EXPECT_EQ(this->dr2, row.dr_0);
    EXPECT_EQ(this->bench->read("delta"), row.ddr);
    const Line closed = expected_line(view, row.y);
    EXPECT_EQ(closed.dr_0, row.dr_0);
    EXPECT_EQ(closed.first_run_clock, row.c);
  }
}

// Contract 7.1 and 7.6 in closed form: all lines of frames of several rotation variants.
TYPED_TEST(CameraUnitTest, WholeFramesGiveTheClosedForm) {
  for (const auto& [frame, variant] : {std::pair{700, 0}, {8500, 2}, {8650, 3}, {8754, 6}})
    for (int y = -273; y <= 251; ++y) {
      SCOPED_TRACE(testing::Message() << "frame " << frame << ", y = " << y);
      this->check_line(view_of(frame, variant, y), y);
      if (this->HasFatalFailure()) return;
    }
}

TYPED_TEST(CameraUnitTest, RandomViewsGiveTheClosedForm) {
  std::mt19937 random(11);
  for (int n = 0; n < 1500; ++n) {
    const auto below = [&](int limit) { return static_cast<int>(random() % limit); };
    const View view{below(1024), below(1024), n % 8 ? below(256) : 0};  // fov 0: SCALE of 1 or 2
    const int y = n % 5 ? below(525) - 273 : 0;
    SCOPED_TRACE(testing::Message()
                 << view.yaw << " " << view.pitch << " " << view.fov << " " << y);
    this->check_line(view, y);
    if (this->HasFatalFailure()) return;
  }
}

// Contract 7.2: line_end restarts the camera from any clock.
TYPED_TEST(CameraUnitTest, LineEndRestartsFromAnyClock) {
  const View view = view_of(700, 0, 100);
  for (int clocks = 0; clocks < 90; ++clocks) {
    this->start_line(view_of(1400, 0, -100), -100);
    for (int c = 0; c < clocks; ++c) this->clock();
    SCOPED_TRACE(clocks);
    this->check_line(view, 100);
    if (this->HasFatalFailure()) return;
  }
}

// Contract 4.1, 7.4 and 9.7: the last clock of a line, and reset, already hold the tracer.
TYPED_TEST(CameraUnitTest, LineEndAndResetActWithinTheClock) {
  for (const char* name : {"line_end_i", "rst_ni"}) {
    const bool level = name[0] == 'l';
    this->run_line(view_of(700, 0, 3), 3);
    EXPECT_EQ(this->out("tracer_reset_o"), 0);
    this->drive(name, level);
    this->settle();
    EXPECT_EQ(this->out("tracer_reset_o"), 1) << name;
    EXPECT_EQ(this->out("load_o"), 1) << name;
    EXPECT_EQ(this->out("load_zero_o"), 1) << name;
    EXPECT_EQ(this->out("idx_load_o"), 1) << name;
    EXPECT_EQ(this->out("idx_start_o"), 0) << name;
    EXPECT_EQ(this->out("i2_init_o"), 0) << name;
    EXPECT_EQ(this->out("run_o"), 1) << name;  // a register
    this->drive(name, !level);
    this->settle();
    EXPECT_EQ(this->out("tracer_reset_o"), 0) << name;
    EXPECT_EQ(this->out("i2_init_o"), 639) << name;
    this->drive(name, level);
    this->clock();
    this->drive(name, !level);
    this->settle();
    EXPECT_EQ(this->out("run_o"), 0) << name;
  }
}

// Contract 7.4, phase RUN.
TYPED_TEST(CameraUnitTest, RunHoldsWhateverTheTracerDoes) {
  this->run_line(view_of(1400, 0, -240), -240);
  std::mt19937 random(3);
  for (int c = 0; c < 1500; ++c) {
    this->drive("stepping_i", random() & 1);
    this->drive("angle_i", random() & 1023);
    this->bench->drive("dr2", "_i", {c & 511, -c & 511, c % 7});
    this->bench->settle();
    ASSERT_EQ(this->out("run_o"), 1);
    ASSERT_EQ(this->out("tracer_reset_o"), 0);
    ASSERT_EQ(this->out("load_o") | this->out("ext_o") | this->out("copy_o"), 0);
    ASSERT_EQ(this->out("idx_load_o"), 0);
    ASSERT_EQ(this->out("i2_init_o"), 639);
    ASSERT_EQ(this->bench->read("delta"), (vec3{-307, 0, -442}));
    this->bench->clock();
  }
}

// Knob dr_bits: the same clocks; the directions in another scale, a few units off.
TYPED_TEST(CameraUnitKnobTest, ClocksAndDirectionsAtDrBits8) { this->check_scale(8, 4); }
TYPED_TEST(CameraUnitKnobTest, ClocksAndDirectionsAtDrBits9) { this->check_scale(9, 5); }
TYPED_TEST(CameraUnitKnobTest, ClocksAndDirectionsAtDrBits12) { this->check_scale(12, 20); }
TYPED_TEST(CameraUnitKnobTest, ClocksAndDirectionsAtDrBits13) { this->check_scale(13, 40); }

}  // namespace
}  // namespace racebeam
