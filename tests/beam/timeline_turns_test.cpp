// Promises of sc/beam/timeline.h: turns, the back door, and rows of the chip's own demo.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/beam/timeline_bench.h"

namespace racebeam {
namespace {

template <class Unit>
class TimelineTurnsTest : public testing::Test {};
TYPED_TEST_SUITE(TimelineTurnsTest, Twins);

TYPED_TEST(TimelineTurnsTest, StepIsAddedAfterEverySoManyFramesModulo2048) {
  auto program = one_shot(6000);
  program.shots[0].yaw = {true, 2046, 1, 3, 0};
  program.shots[0].pitch = {true, 1, -1, 1, 0};
  program.shots[0].fov = {true, 250, 7, 2, 0};
  Dut<TypeParam> d(program);
  for (int frame = 0; frame < 6000; ++frame) {
    ASSERT_EQ(d.angle(AngleYaw, 0), (2046 + frame / 3) % 2048) << frame;
    ASSERT_EQ(d.angle(AnglePitch, 0), (3 * 2048 + 1 - frame) % 2048) << frame;
    ASSERT_EQ(d.angle(AngleFov, 0), (250 + 7 * (frame / 2)) % 256) << frame;
    d.count(1);
  }
}

TYPED_TEST(TimelineTurnsTest, StepOfAHundredThousandFramesWaits) {
  auto program = one_shot(16383);
  program.shots[0].yaw = {true, 3, 9, 100000, 0};
  program.shots[0].pitch = {true, 3, 9, 16382, 0};
  Dut<TypeParam> d(program);
  d.count(16381);
  EXPECT_EQ(d.angle(AnglePitch, 0), 3);
  d.count(1);
  EXPECT_EQ(d.angle(AnglePitch, 0), 12);
  EXPECT_EQ(d.angle(AngleYaw, 0), 3);
}

// Contract 7.5: y as signed 9 bits, so that the lines above -256 are those below 255.
TYPED_TEST(TimelineTurnsTest, LinesAreAddedAsNineBits) {
  auto program = one_shot(2);
  program.shots[0].yaw = {true, 10, 0, 1, 1};
  program.shots[0].pitch = {true, 10, 0, 1, -7};
  program.shots[0].fov = {true, 10, 0, 1, 2};
  Dut<TypeParam> d(program);
  for (int y = -273; y <= 251; ++y) {
    const int y9 = y < -256 ? y + 512 : y;
    ASSERT_EQ(d.angle(AngleYaw, y), mod(10 + y9, 2048)) << y;
    ASSERT_EQ(d.angle(AnglePitch, y), mod(10 - 7 * y9, 2048)) << y;
    ASSERT_EQ(d.angle(AngleFov, y), mod(10 + 2 * y9, 256)) << y;
  }
}

// A shot in the middle of another's wait: what it sets starts anew, the rest keeps its beat.
TYPED_TEST(TimelineTurnsTest, ShotLoadsWhatItSetsAndTheOthersKeepTheirBeat) {
  auto program = one_shot(40);
  program.shots[0].yaw = {true, 100, 10, 4, 0};
  program.shots[0].pitch = {true, 200, -10, 4, 0};
  program.shots.push_back(program.shots[0]);
  program.shots[1].frame = 6;
  program.shots[1].yaw = {true, 500, 1, 3, 0};
  program.shots[1].pitch.load = false;
  Dut<TypeParam> d(program);
  const int yaw[] = {100, 100, 100, 100, 110, 110, 500, 500, 500, 501, 501, 501, 502};
  const int pitch[] = {200, 200, 200, 200, 190, 190, 190, 190, 180, 180, 180, 180, 170};
  for (int frame = 0; frame < 13; ++frame, d.count(1)) {
    EXPECT_EQ(d.angle(AngleYaw, 0), yaw[frame]) << frame;
    EXPECT_EQ(d.angle(AnglePitch, 0), pitch[frame]) << frame;
  }
}

TYPED_TEST(TimelineTurnsTest, AngleFollowsSourceAndLineAlone) {
  auto program = one_shot(2);
  program.shots[0].yaw = {true, 10, 0, 1, 1};
  program.shots[0].pitch = {true, 20, 0, 1, 0};
  program.shots[0].fov = {true, 30, 0, 1, 0};
  Dut<TypeParam> d(program);
  const auto after = [&](const char* port, int value) {
    d.bench[port].drive(value);
    d.bench.settle();
    return d.get("angle_o");
  };
  EXPECT_EQ(after("y_i", 5), 15);
  EXPECT_EQ(after("src_i", AnglePitch), 20);
  EXPECT_EQ(after("src_i", AngleFov), 30);
  EXPECT_EQ(after("src_i", AngleYaw), 15);
  EXPECT_EQ(after("y_i", -3), 7);
}

// The back door: at any frame, from any frame, and then it counts on.
TYPED_TEST(TimelineTurnsTest, DepositIsAsIfItHadCountedThere) {
  std::minstd_rand random(172);
  scene_program program = random_program(random);
  while (program.shots.size() < 6) program = random_program(random);
  Dut<TypeParam> d(program);
  for (int n = 0; n < 60; ++n) {
    const int to = static_cast<int>((random() >> 4) % program.frames);
    d.unit.deposit(to);
    d.bench.settle();
    for (int frame = to; frame < program.frames && frame < to + 9; ++frame, d.count(1)) {
      ASSERT_NO_FATAL_FAILURE(d.check(frame)) << "from " << to;
    }
  }
}

// Many programs: the registers after a seek are those after counting.
TEST(TimelineCore, SeekGivesTheRegistersOfCounting) {
  std::minstd_rand random(99);
  for (int n = 0; n < 400; ++n) {
    const scene_program program = random_program(random);
    timeline_core counts;
    counts.clock({false, false, false, 0}, program);
    for (int frame = 0; frame < program.frames; ++frame) {
      timeline_core seeks;
      seeks.seek(frame, program);
      ASSERT_EQ(seeks.frame_q, counts.frame_q);
      ASSERT_EQ(seeks.shot_q, counts.shot_q) << "program " << n << ", frame " << frame;
      for (const int src : {AngleYaw, AnglePitch, AngleFov}) {
        ASSERT_EQ(seeks.turns_q[src].waited, counts.turns_q[src].waited) << n << ", " << frame;
        for (const int y : {0, -240}) {
          ASSERT_EQ(seeks.angle(src, y, program), expected_angle(program, frame, src, y));
          ASSERT_EQ(counts.angle(src, y, program), expected_angle(program, frame, src, y));
        }
      }
      counts.clock({true, true, false, 0}, program);
    }
  }
}

// --- Rows of contract 17.7 as a program --------------------------------------------------------

constexpr int rgb(int r, int g, int b) { return r << 4 | g << 2 | b; }
constexpr int four(int a, int b, int c, int d) { return a | b << 6 | c << 12 | d << 18; }
/// Contract 15.2.
constexpr int Palettes[3] = {four(rgb(0, 0, 0), rgb(0, 0, 1), rgb(0, 1, 2), rgb(2, 2, 3)),
                             four(rgb(0, 0, 2), rgb(0, 1, 2), rgb(1, 2, 2), rgb(1, 3, 2)),
                             four(rgb(1, 0, 1), rgb(2, 1, 1), rgb(3, 2, 1), rgb(3, 3, 2))};

/// A flight through the pillars.
shot_row pillars(int frame, bool restart) {
  shot_row shot;
  shot.frame = frame;
  shot.restart = restart;
  shot.start_room = 4;
  shot.start = {0, -224, 0};
  shot.velocity = {0, 0, -1};
  shot.interlace = true;
  shot.colours = Palettes[0];
  shot.pattern_colours = Palettes[2];
  return shot;
}

/// The demo from frame `first` on, beside the program from frame 0 on.
template <class Unit>
void expect_demo(const scene_program& program, int first) {
  Dut<Unit> d(program);
  sequencer_core demo;
  for (int frame = 0; frame < program.frames; ++frame, d.count(1)) {
    SCOPED_TRACE(frame);
    demo.frame_q = first + frame;
    for (const int dr2_y : {0, 63, 64, 200, -1, -64, -65, -256})
      for (const bool run : {false, true}) {
        d.tracer(dr2_y, run);
        const auto want = demo.comb({true, false, run, dr2_y}, knobs{});
        ASSERT_EQ(d.get("colours_o"), Palettes[want.palette]) << dr2_y;
        ASSERT_EQ(d.get("lock_o"), want.lock) << dr2_y;
        ASSERT_EQ(d.get("shading_b_o"), want.shading_b);
        ASSERT_EQ(d.get("scene_interlace_o"), want.scene_interlace);
        ASSERT_EQ(d.get("inverse_o"), want.inverse);
        ASSERT_EQ(d.get("nav_reset_o"), want.nav_reset);
        ASSERT_EQ(d.bench.read("start"), want.start);
        ASSERT_EQ(d.get("start_room_o"), want.start_room);
        ASSERT_EQ(d.bench.read("velocity"), want.velocity);
      }
    for (const int src : {AngleYaw, AnglePitch, AngleFov})
      for (const int y : {-273, -257, -240, -1, 0, 100, 239, 251})
        ASSERT_EQ(d.angle(src, y), demo.angle(src, y)) << "source " << src << ", y = " << y;
  }
}

// Frames 2304 to 2815: focal length and line, partial and full pattern, fast turns, two flights.
TYPED_TEST(TimelineTurnsTest, ProgramOfThePatternRowsIsTheChipsDemo) {
  auto program = one_shot(512);
  auto& shots = program.shots;
  shots = {pillars(0, true), pillars(128, false), pillars(256, true), pillars(384, false)};
  shots[0].yaw = {true, 2 * (2304 / 4), 2, 4, 0};
  shots[0].pitch = {true, 2 * (1023 - 2304 / 8), -2, 8, 0};
  shots[0].fov = {true, 2304 / 2, 1, 2, 1};
  shots[1].yaw = {true, 2 * 2432, 2, 1, 0};
  shots[1].pitch = {true, 2 * (1023 - 2432 / 2), -2, 2, 0};
  shots[1].fov = {false, 0, 1, 2, 1};
  shots[1].pattern = PatternPartial;
  for (const int s : {2, 3}) {  // scene 2, seen by nobody
    shots[s].start = {0, 160, 0};
    shots[s].velocity = {0, 0, -2};
    shots[s].interlace = false;
    shots[s].shading_b = true;
    shots[s].pattern = PatternFull;
    shots[s].yaw = {false, 0, 2, 1, s == 3 ? 2 : 0};
    shots[s].pitch = {false, 0, -2, 2, 0};
    shots[s].fov = {true, 96, 0, 1, 0};
  }
  expect_demo<TypeParam>(program, 2304);
}

// Frames 8192 to 8703: twists of all strengths, inversion, two flights.
TYPED_TEST(TimelineTurnsTest, ProgramOfTheTwistedRowsIsTheChipsDemo) {
  auto program = one_shot(512);
  auto& shots = program.shots;
  shots = {pillars(0, true), pillars(128, false), pillars(256, true), pillars(384, false)};
  const int yaw_lines[] = {0, 2, 2, 4}, pitch_lines[] = {0, 0, 2, 4};
  for (int s = 0; s < 4; ++s) {
    shots[s].yaw = {s == 0, 2 * (8192 / 4), 2, 4, yaw_lines[s]};
    shots[s].pitch = {s == 0, 2 * (1023 - 8192 / 8), -2, 8, pitch_lines[s]};
    shots[s].fov = {s == 0, 96, 0, 1, 0};
    shots[s].inverse = s % 2 == 1;
  }
  expect_demo<TypeParam>(program, 8192);
}

}  // namespace
}  // namespace racebeam
