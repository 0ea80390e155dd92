// Promises of sc/beam/timeline.h: frames, shots and what they choose.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/timeline.h"

#include <gtest/gtest.h>

#include "tests/beam/timeline_bench.h"

namespace racebeam {
namespace {

template <class Unit>
class TimelineTest : public testing::Test {};
TYPED_TEST_SUITE(TimelineTest, Twins);

/// Three shots with nothing in common.
scene_program three_shots() {
  scene_program program = one_shot(20);
  program.shots.resize(3);
  shot_row &first = program.shots[0], &second = program.shots[1], &third = program.shots[2];
  first.restart = true;
  first.start_room = 8190;
  first.start = {1, -2, 32767};
  first.velocity = {0, 0, -1024};
  first.yaw = {true, 2040, 3, 1, 0};
  first.pitch = {true, 5, -2, 3, 1};
  first.fov = {true, 96, 0, 1, 0};
  first.interlace = true;
  first.colours = 0x123456;
  second = first;
  second.frame = 7;
  second.restart = false;
  second.velocity = {1023, -5, 6};
  second.yaw.load = second.pitch.load = false;
  second.fov = {true, 250, 5, 2, -1};
  second.interlace = false;
  second.shading_b = second.inverse = true;
  second.colours = 0xabcdef;
  third = second;
  third.frame = 13;
  third.restart = true;
  third.start_room = 0;
  third.start = {-32768, 300, -4};
  third.yaw = {true, 0, -300, 2, 2};
  third.pattern = PatternPartial;
  third.pattern_colours = 0x00ff01;
  third.fov.load = false;
  return program;
}

TYPED_TEST(TimelineTest, ShotsHoldFromTheirFrameOnAndTheProgramGoesRound) {
  Dut<TypeParam> d(three_shots());
  for (int round = 0; round < 3; ++round) {
    for (int frame = 0; frame < 20; ++frame) {
      d.check(frame);
      if (this->HasFatalFailure()) return;
      d.bench.clock(3);
      d.check(frame);
      if (this->HasFatalFailure()) return;
      d.count(1);
    }
    EXPECT_EQ(d.get("frame_o"), 20);
    d.bench.clock();
  }
}

// As 12799 on the chip, contract 17.1.
TYPED_TEST(TimelineTest, FrameAfterTheLastLastsOneClock) {
  Dut<TypeParam> d(three_shots());
  for (const int frame_end : {0, 1}) {
    d.count(19);
    d.bench.clock(100);
    EXPECT_EQ(d.get("frame_o"), 19);
    d.count(1);
    EXPECT_EQ(d.get("frame_o"), 20);
    EXPECT_EQ(d.get("nav_reset_o"), 0);
    d.bench["frame_end_i"].drive(frame_end);
    d.bench.clock();
    EXPECT_EQ(d.get("frame_o"), 0);
    EXPECT_EQ(d.get("nav_reset_o"), 1);
    d.bench["frame_end_i"].drive(0);
    d.bench.clock(3);
    d.check(0);
  }
}

TYPED_TEST(TimelineTest, OneFrameForOneClockOfFrameEnd) {
  Dut<TypeParam> d(three_shots());
  for (int frame = 1; frame < 20; ++frame) {
    d.bench.clock(frame);
    d.bench["frame_end_i"].drive(1);
    d.bench.settle();
    EXPECT_EQ(d.get("frame_o"), frame - 1) << "before the edge";
    d.bench.clock();
    d.bench["frame_end_i"].drive(0);
    EXPECT_EQ(d.get("frame_o"), frame);
  }
}

TYPED_TEST(TimelineTest, ResetGoesToFrame0AndItsTurns) {
  Dut<TypeParam> d(three_shots());
  for (const int frames : {5, 6, 12, 17}) {
    d.count(frames);
    d.bench["rst_ni"].drive(0);
    d.bench["frame_end_i"].drive(1);
    d.bench.settle();
    EXPECT_EQ(d.get("frame_o"), frames) << "the reset is synchronous";
    d.bench.clock(2);
    d.bench["rst_ni"].drive(1);
    d.bench["frame_end_i"].drive(0);
    d.bench.settle();
    d.check(0);
    d.count(8);
    d.check(8);
    d.bench["rst_ni"].drive(0);
    d.bench.clock();
    d.bench["rst_ni"].drive(1);
    d.bench.settle();
  }
}

// Contract 17.4.
TYPED_TEST(TimelineTest, PatternIsShownWhereTheRayIsHighOrLowWithoutAClock) {
  Dut<TypeParam> d(three_shots());
  d.count(13);
  for (int dr2_y = -512; dr2_y < 512; ++dr2_y)
    for (const bool run : {true, false}) {
      d.tracer(dr2_y, run);
      const bool shown = (dr2_y >> 6 & 3) != 0;
      ASSERT_EQ(d.get("lock_o"), shown && run) << dr2_y;
      ASSERT_EQ(d.get("colours_o"), shown ? 0x00ff01 : 0xabcdef) << dr2_y;
    }
}

TYPED_TEST(TimelineTest, FullPatternIsShownWhateverTheRay) {
  auto program = three_shots();
  program.shots[2].pattern = PatternFull;
  Dut<TypeParam> d(program);
  d.count(13);
  for (const int dr2_y : {0, 63, 64, -1, -512})
    for (const bool run : {true, false}) {
      d.tracer(dr2_y, run);
      EXPECT_EQ(d.get("lock_o"), run);
      EXPECT_EQ(d.get("colours_o"), 0x00ff01);
    }
}

// Knob dr_bits: gated by the same part of the picture.
TYPED_TEST(TimelineTest, PatternGateScalesWithTheWidthOfDr) {
  knobs k;
  k.dr_bits = 13;
  Dut<TypeParam> d(three_shots(), k);
  d.count(13);
  for (int dr2_y = -512; dr2_y < 512; dr2_y += 13)
    for (const int fraction : {0, 7}) {
      d.tracer(8 * dr2_y + fraction, true);
      ASSERT_EQ(d.get("lock_o"), (dr2_y >> 6 & 3) != 0) << dr2_y;
    }
}

TYPED_TEST(TimelineTest, NoInputIsMissedUnderRandomOnes) {
  std::minstd_rand random(17);
  scene_program program = random_program(random);
  while (program.frames < 20 || program.shots.size() < 4) program = random_program(random);
  for (std::size_t s = 0; s < program.shots.size(); ++s) program.shots[s].pattern = s % 3;
  Dut<TypeParam> d(program);
  timeline_core core;
  core.seek(0, program);
  const knobs k = program.fitted({});
  const auto inputs = [&]() -> timeline_core::inputs {
    return {d.get("rst_ni") != 0, d.get("frame_end_i") != 0, d.get("run_i") != 0,
            static_cast<int>(d.bench["dr2_y_i"].signed_value())};
  };
  const auto check = [&] {
    const auto want = core.comb(inputs(), program, k);
    ASSERT_EQ(d.get("frame_o"), core.frame_q);
    ASSERT_EQ(d.get("lock_o"), want.lock);
    ASSERT_EQ(d.get("colours_o"), want.colours);
    ASSERT_EQ(d.get("nav_reset_o"), want.nav_reset);
    ASSERT_EQ(d.get("start_room_o"), want.start_room);
    ASSERT_EQ(d.bench.read("velocity"), want.velocity);
    ASSERT_EQ(d.get("angle_o"), core.angle(d.get("src_i"), d.bench["y_i"].signed_value(), program));
  };
  run_beside(
      d.bench, 31, 20000, [&] { core.clock(inputs(), program); }, check);
}

}  // namespace
}  // namespace racebeam
