// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/sequencer.h"

#include <gtest/gtest.h>

#include "tb/twin/unit_bench.h"
#include "tests/support/own_rtl.h"

namespace racebeam {
namespace {

enum LockKind { NoLock, Partial, Full };

/// One row of the timeline, contract 17.7.
struct Row {
  int first, last;
  int scene;      // selector e
  int palette;    // outside the lock pattern
  int variant;    // of the rotation
  LockKind lock;  // palette 2 where the pattern is shown
  bool fast;      // rotation
  bool inverse;   // colours
  bool restarts;  // flight restarts every 256 frames
};
const Row Timeline[] = {
    {0, 2047, 0, 0, 0, NoLock, false, false, false},
    {2048, 2175, 0, 0, 4, NoLock, false, false, true},
    {2176, 2303, 0, 0, 5, NoLock, false, false, true},
    {2304, 2431, 1, 0, 6, NoLock, false, false, true},
    {2432, 2559, 1, 0, 7, Partial, true, false, true},
    {2560, 2687, 2, 2, 0, Full, true, false, true},
    {2688, 2815, 2, 2, 1, Full, true, false, true},
    {2816, 2943, 3, 2, 2, Full, true, false, true},
    {2944, 3071, 3, 2, 3, Full, true, false, true},
    {3072, 3199, 4, 1, 4, Partial, true, false, true},
    {3200, 3327, 4, 1, 5, Partial, true, false, true},
    {3328, 3455, 1, 0, 6, Partial, true, false, true},
    {3456, 3583, 1, 0, 7, Partial, true, false, true},
    {3584, 3711, 6, 1, 0, Partial, true, false, true},
    {3712, 3839, 6, 1, 1, Partial, true, false, true},
    {3840, 3967, 7, 0, 2, Partial, true, false, true},
    {3968, 4095, 7, 0, 3, Partial, true, false, true},
    {4096, 6143, 2, 1, 0, NoLock, false, false, false},
    {6144, 8191, 3, 0, 0, NoLock, false, false, false},
    {8192, 8319, 0, 0, 0, NoLock, false, false, true},
    {8320, 8447, 0, 0, 1, NoLock, false, true, true},
    {8448, 8575, 1, 0, 2, NoLock, false, false, true},
    {8576, 8703, 1, 0, 3, NoLock, false, true, true},
    {8704, 8831, 2, 1, 6, NoLock, false, false, true},
    {8832, 8959, 2, 1, 7, NoLock, false, false, true},
    {8960, 9087, 3, 0, 4, NoLock, false, false, true},
    {9088, 9215, 3, 0, 5, NoLock, false, false, true},
    {9216, 9343, 4, 1, 0, NoLock, false, false, true},
    {9344, 9471, 4, 1, 1, NoLock, false, false, true},
    {9472, 9599, 5, 0, 2, NoLock, true, false, true},
    {9600, 9727, 5, 0, 3, NoLock, true, false, true},
    {9728, 9855, 6, 0, 6, NoLock, false, false, true},
    {9856, 9983, 6, 0, 7, NoLock, false, false, true},
    {9984, 10111, 7, 1, 4, NoLock, false, false, true},
    {10112, 10239, 7, 1, 5, NoLock, false, false, true},
    {10240, 12287, 5, 2, 0, NoLock, false, false, false},
    {12288, 12798, 6, 0, 0, NoLock, false, false, false},
};
constexpr int DemoEnd = 12799;

/// What a scene brings along, contract 17.1 by selector e.
struct Scene {
  int flags;
  bool shading_b;
  int start_y, velocity_z;
  bool interlace;
};
constexpr int W = SceneWindows, P = ScenePortals, B = SceneBlocked, H = SceneHeights,
              U = SceneTunnel, N = SceneNarrow;
const Scene Scenes[8] = {
    {W | B, false, -224, -1, true}, {W | B, false, -224, -1, true},
    {U, true, 160, -2, false},      {H, false, -224, -1, true},
    {H | B, false, -224, -1, true}, {W | P | B | N, true, 32, -1, true},
    {U | N, false, 160, -2, false}, {H | N, false, -224, -1, true},
};

constexpr int mod(int value, int size) { return (value % size + size) % size; }

/// Angles (2 * angle10) and focal length, contract 7.5 and 17.3.
int expected_angle(int frame, const Row& row, int src, int y) {
  const int y9 = mod(y + 256, 512) - 256;
  const int v = row.variant;
  switch (src) {
    case AngleYaw: {
      const int turn = row.fast ? frame : frame / 4;
      return 2 * mod(turn + (v == 1 || v == 2 ? y9 : v == 3 ? 2 * y9 : 0), 1024);
    }
    case AnglePitch: {
      const int turn = 1023 - mod(row.fast ? frame / 2 : frame / 8, 1024);
      return 2 * mod(turn + (v == 2 ? y9 : v == 3 ? 2 * y9 : 0), 1024);
    }
    default: return v < 4 ? 96 : mod(frame / 2 + (v >= 6 ? y9 : 0), 256);
  }
}

template <class Unit>
class SequencerTest : public testing::Test {
 protected:
  explicit SequencerTest(const knobs& k = {}) : unit("dut", k), bench(unit) {
    bench.clock();
    bench["rst_ni"].drive(1);
    bench.settle();
  }

  int out(const char* name) { return bench[name].value(); }

  /// Lets `frames` frames end.
  void count(int frames) {
    if (frames == 0) return;
    bench["frame_end_i"].drive(1);
    bench.clock(frames);
    bench["frame_end_i"].drive(0);
    bench.settle();
  }

  void tracer(int dr2_y, bool run) {
    bench["dr2_y_i"].drive(dr2_y);
    bench["run_i"].drive(run);
    bench.settle();
  }

  /// Everything but the angle and what depends on dr2_y and run.
  void check_frame(int frame, const Row& row) {
    const Scene& scene = Scenes[row.scene];
    ASSERT_EQ(out("frame_o"), frame);
    ASSERT_EQ(out("scene_flags_o"), scene.flags);
    ASSERT_EQ(out("shading_b_o"), scene.shading_b);
    ASSERT_EQ(out("scene_interlace_o"), scene.interlace);
    ASSERT_EQ(bench.read("start"), (vec3{0, scene.start_y, 0}));
    ASSERT_EQ(out("start_room_o"), 4);
    ASSERT_EQ(bench.read("velocity"), (vec3{0, 0, scene.velocity_z}));
    ASSERT_EQ(out("inverse_o"), row.inverse);
    // Contract 13.
    ASSERT_EQ(out("nav_reset_o"), frame % 2048 == 0 || (row.restarts && frame % 256 == 0));
  }

  /// The lock effect, contract 17.4.
  void check_lock(const Row& row, int dr2_y, bool run) {
    tracer(dr2_y, run);
    const bool shown = row.lock == Full || (row.lock == Partial && (dr2_y >> 6 & 3) != 0);
    ASSERT_EQ(out("palette_o"), shown ? 2 : row.palette) << "dr2_y = " << dr2_y;
    ASSERT_EQ(out("lock_o"), shown && run) << "dr2_y = " << dr2_y;
  }

  Unit unit;
  UnitBench bench;
};

template <class Unit>
class SequencerWideDrTest : public SequencerTest<Unit> {
 protected:
  static knobs wide() {
    knobs k;
    k.dr_bits = 13;
    return k;
  }
  SequencerWideDrTest() : SequencerTest<Unit>(wide()) {}
};

using Twins = testing::Types<sequencer, own_rtl<sequencer>>;
TYPED_TEST_SUITE(SequencerTest, Twins);
TYPED_TEST_SUITE(SequencerWideDrTest, Twins);

// Contract 17.7, 17.1 and 13: every frame of the demo.
TYPED_TEST(SequencerTest, EveryFrameFollowsTheTimeline) {
  int frame = 0;
  for (const Row& row : Timeline) {
    ASSERT_EQ(row.first, frame);
    for (; frame <= row.last; ++frame) {
      SCOPED_TRACE(frame);
      this->check_frame(frame, row);
      this->check_lock(row, frame % 7 < 2 ? frame & 63 : frame, frame & 1);
      if (this->HasFatalFailure()) return;
      this->count(1);
    }
  }
  EXPECT_EQ(frame, DemoEnd);
}

// Contract 17.1: the value 12799 lives for one clock, whether or not a frame ends in it.
TYPED_TEST(SequencerTest, Frame12799LastsOneClock) {
  for (const int frame_end : {0, 1}) {
    this->count(DemoEnd - 1);
    EXPECT_EQ(this->out("frame_o"), 12798);
    this->bench.clock(1600);
    EXPECT_EQ(this->out("frame_o"), 12798);
    this->count(1);
    EXPECT_EQ(this->out("frame_o"), 12799);
    this->bench["frame_end_i"].drive(frame_end);
    this->bench.clock();
    EXPECT_EQ(this->out("frame_o"), 0);
    EXPECT_EQ(this->out("nav_reset_o"), 1);
    this->bench["frame_end_i"].drive(0);
    this->bench.clock(3);
    EXPECT_EQ(this->out("frame_o"), 0);
  }
}

TYPED_TEST(SequencerTest, CountsOneFrameForOneClockOfFrameEnd) {
  auto& bench = this->bench;
  for (int frame = 1; frame < 20; ++frame) {
    bench.clock(frame);
    EXPECT_EQ(this->out("frame_o"), frame - 1);
    bench["frame_end_i"].drive(1);
    bench.settle();
    EXPECT_EQ(this->out("frame_o"), frame - 1);
    bench.clock();
    bench["frame_end_i"].drive(0);
    EXPECT_EQ(this->out("frame_o"), frame);
  }
}

TYPED_TEST(SequencerTest, ResetGoesToFrame0) {
  this->count(5000);
  this->bench["rst_ni"].drive(0);
  this->bench["frame_end_i"].drive(1);
  this->bench.settle();
  EXPECT_EQ(this->out("frame_o"), 5000);  // the reset is synchronous
  this->bench.clock(2);
  EXPECT_EQ(this->out("frame_o"), 0);
  this->bench["rst_ni"].drive(1);
  this->bench.clock(3);
  EXPECT_EQ(this->out("frame_o"), 3);
}

// Contract 17.4: which lines and pixels of a frame show the pattern; no clock between.
TYPED_TEST(SequencerTest, LockFollowsBits7And6OfDr2WithinTheClock) {
  int frame = 0;
  for (const Row& row : Timeline) {
    SCOPED_TRACE(row.first);
    this->count(row.first - frame);
    frame = row.first;
    for (int dr2_y = -512; dr2_y < 512; dr2_y += 21)
      for (const bool run : {false, true}) this->check_lock(row, dr2_y, run);
    for (const int dr2_y : {0, 63, 64, 127, 128, 192, 255, 256, 319, 320, -1, -64, -65, -256})
      for (const bool run : {true, false}) this->check_lock(row, dr2_y, run);
    if (this->HasFatalFailure()) return;
    this->bench.clock();
  }
}

// Knob dr_bits: the pattern is gated by the same part of the picture, so by bits 10 and 9 of 13.
TYPED_TEST(SequencerWideDrTest, LockGateScalesWithTheWidthOfDr) {
  this->count(3072);
  for (int dr2_y = -512; dr2_y < 512; dr2_y += 13)
    for (const int fraction : {0, 7}) {
      this->tracer(8 * dr2_y + fraction, true);
      ASSERT_EQ(this->out("lock_o"), (dr2_y >> 6 & 3) != 0) << dr2_y;
    }
}

// Contract 7.5 and 17.3.
TYPED_TEST(SequencerTest, AnglesFollowTheRotationVariants) {
  auto& bench = this->bench;
  int frame = 0;
  for (const Row& row : Timeline)
    for (const int at : {row.first, row.first + 5, (row.first + row.last) / 2, row.last}) {
      this->count(at - frame);
      frame = at;
      for (const int src : {AngleFov, AngleYaw, AnglePitch})
        for (const int y : {-273, -257, -256, -240, -239, -1, 0, 1, 100, 239, 251}) {
          bench["src_i"].drive(src);
          bench["y_i"].drive(y);
          bench.settle();
          ASSERT_EQ(this->out("angle_o"), expected_angle(frame, row, src, y))
              << "frame " << frame << ", y = " << y << ", source " << src;
        }
      bench.clock();
    }
}

// Contract 13.1: a full turn of yaw in 4096 frames, half a turn of pitch in 4096.
TYPED_TEST(SequencerTest, CameraOfTheFirstPartTurnsAsWritten) {
  auto& bench = this->bench;
  for (int frame = 0; frame < 2048; ++frame) {
    bench["src_i"].drive(AngleYaw);
    bench.settle();
    ASSERT_EQ(this->out("angle_o"), 2 * (frame / 4));
    bench["src_i"].drive(AnglePitch);
    bench.settle();
    ASSERT_EQ(this->out("angle_o"), 2 * (1023 - frame / 8));
    bench["src_i"].drive(AngleFov);
    bench.settle();
    ASSERT_EQ(this->out("angle_o"), 96);
    this->count(1);
  }
}

}  // namespace
}  // namespace racebeam
