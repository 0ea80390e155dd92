// Promises of sc/beam/camera_unit.h: results and clocks of all lines, contract section 7 and
// vectors 20.1.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/camera_unit.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "tests/beam/camera_unit_bench.h"

namespace racebeam {
namespace {

TYPED_TEST_SUITE(CameraUnitTest, Twins);
TYPED_TEST_SUITE(CameraUnitKnobTest, Twins);

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
    const int fov = n % 8 ? below(256) : 0;  // 0: SCALE of 1 or 2
    const View view{below(2048), below(2048), fov};
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

// Header, Comb: in every clock before RUN, i2_init_o follows y_i alone (contract 7.4, target of
// pass 1).
TYPED_TEST(CameraUnitTest, TargetOfTheDownPassFollowsTheLineWithinTheClock) {
  this->start_line(view_of(700, 0, 3), 3);
  int followed = 0;
  while (!this->out("run_o")) {
    this->drive("y_i", 100);
    this->bench->settle();
    const int at_100 = this->out("i2_init_o");
    this->drive("y_i", 5);
    this->bench->settle();
    const int at_5 = this->out("i2_init_o");
    if (at_100 == (100 ^ 256)) {
      EXPECT_EQ(at_5, 5 ^ 256);
      ++followed;
    } else {
      EXPECT_EQ(at_5, at_100);
    }
    this->clock();
  }
  EXPECT_GE(followed, 3);  // LOAD and SCALE of pass 1
}

// Contract 7.4: load_zero is 1 except in phase LOAD of the second and third pass.
TYPED_TEST(CameraUnitTest, LoadZeroIsOffInTwoClocksOfTheLine) {
  this->start_line(view_of(700, 0, 3), 3);
  std::vector<int> starts;
  for (int c = 0; c < 100; ++c, this->clock()) {
    if (this->out("load_zero_o")) continue;
    EXPECT_EQ(this->out("load_o"), 1) << c;
    starts.push_back(this->out("idx_start_o"));
  }
  EXPECT_EQ(this->out("run_o"), 1);
  EXPECT_EQ(starts, (std::vector<int>{256, 512}));
}

// Contract 7.4, phase RUN.
TYPED_TEST(CameraUnitTest, RunHoldsWhateverTheTracerDoes) {
  this->run_line(view_of(1400, 0, -240), -240);
  std::mt19937 random(3);
  for (int c = 0; c < 1500; ++c) {
    this->drive("step_i", random() & 1);
    this->drive("angle_i", random() & 2047);
    this->bench->drive("dr2", "_i", {c & 511, -c & 511, c % 7});
    this->bench->settle();
    ASSERT_EQ(this->out("run_o"), 1);
    ASSERT_EQ(this->out("tracer_reset_o"), 0);
    ASSERT_EQ(this->out("load_o") | this->out("ext_o") | this->out("copy_ext_o"), 0);
    ASSERT_EQ(this->out("idx_load_o"), 0);
    ASSERT_EQ(this->out("i2_init_o"), 639);
    ASSERT_EQ(this->bench->read("delta"), (vec3{-307, 0, -442}));
    this->bench->clock();
  }
}

// Knob head_start: the same vectors, so many clocks later; the end of a line ends the wait.
TYPED_TEST(CameraUnitKnobTest, HeadStart1HoldsRunBackAndNothingElse) { this->check_head_start(1); }
TYPED_TEST(CameraUnitKnobTest, HeadStart37HoldsRunBackAndNothingElse) {
  this->check_head_start(37);
}
TYPED_TEST(CameraUnitKnobTest, HeadStart320HoldsRunBackAndNothingElse) {
  this->check_head_start(320);
}

// Knob ddr_fraction_bits: dr_0 and ddr are made of a right vector without the other bits.
TYPED_TEST(CameraUnitKnobTest, DdrWithoutFractionBits) { this->check_ddr_fraction(0); }
TYPED_TEST(CameraUnitKnobTest, DdrWith4FractionBits) { this->check_ddr_fraction(4); }
TYPED_TEST(CameraUnitKnobTest, DdrWith8FractionBits) { this->check_ddr_fraction(8); }

// Knob camera_cosine, of the model alone: the same clocks, the directions of the angles.
using CameraUnitModelTest = CameraUnitKnobTest<camera_unit>;
TEST_F(CameraUnitModelTest, ExactCosinesComeInTheSameClocks) {
  knobs k;
  k.camera_cosine = CosineExact;
  build(k);
  const View views[] = {{0, 0, 96},       {512, 0, 96},     {1024, 512, 1}, {300, 2000, 96},
                        {1700, 100, 255}, {2047, 1023, 96}, {831, 1400, 17}};
  for (const View& of_line : views)
    for (const int line : {-240, -1, 0, 97, 239}) {
      check_line(of_line, line, expected_line(of_line, line, CosineExact));
      if (HasFatalFailure()) return;
    }
}

TEST_F(CameraUnitModelTest, ExactCosinesAreWithinARoundingOfTheAngles) {
  knobs k;
  k.camera_cosine = CosineExact;
  build(k);
  const double unit = std::acos(0.0) / 512;  // radians
  for (int angle = 0; angle < 2048; angle += 5) {
    run_line({angle, 0, 96}, 0);  // level: the right vector is (cos yaw, 0, -sin yaw)
    const vec3 ddr = bench->read("delta");
    EXPECT_NEAR(ddr[0], 511 * std::cos(angle * unit), 0.51) << angle;
    EXPECT_EQ(ddr[1], 0);
    EXPECT_NEAR(ddr[2], -511 * std::sin(angle * unit), 0.51) << angle;
  }
}

// Knob dr_bits: the same clocks; the directions in another scale, a few units off.
TYPED_TEST(CameraUnitKnobTest, ClocksAndDirectionsAtDrBits8) { this->check_scale(8, 4); }

TYPED_TEST(CameraUnitKnobTest, ClocksAndDirectionsAtDrBits9) { this->check_scale(9, 5); }
TYPED_TEST(CameraUnitKnobTest, ClocksAndDirectionsAtDrBits12) { this->check_scale(12, 20); }
TYPED_TEST(CameraUnitKnobTest, ClocksAndDirectionsAtDrBits13) { this->check_scale(13, 40); }

}  // namespace
}  // namespace racebeam
