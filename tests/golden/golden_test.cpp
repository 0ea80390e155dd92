// The golden tracers against each other and against the chip without its limits.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tb/golden/tracer_4.h"
#include "tb/show/demo_parts.h"
#include "tests/golden/golden_hits.h"
#include "tests/support/core_picture.h"
#include "tests/support/unlimited.h"

namespace racebeam {
namespace {

using Tracer = GoldenTracer;

GoldenPicture golden(Tracer tracer, int frame, const knobs& k = {}) {
  return golden_picture(tracer, GoldenWorld(frame, k), GoldenCamera(frame, k));
}

bool has_pattern(const DemoPart& part) {
  return GoldenWorld(part.first_frame, {}).lock != GoldenLock::None;
}

/// One frame of a part, not in its middle.
int frame_of(const DemoPart& part) {
  return part.first_frame + (part.last_frame - part.first_frame) * 2 / 3;
}

void expect_chip_equals_trace_4(int frame, const knobs& k) {
  const GoldenPicture chip = core_picture(frame, k), want = golden(Tracer::Trace4, frame, k);
  ASSERT_EQ(chip.size(), want.size());
  for (std::size_t i = 0; i < chip.size(); ++i)
    ASSERT_EQ(chip[i], want[i]) << "frame " << frame << " column " << i % 640 << " row " << i / 640;
}

TEST(Trace4, EqualsTheChipWithoutItsLimitsInEveryPart) {
  for (const DemoPart& part : demo_parts())
    if (!has_pattern(part)) expect_chip_equals_trace_4(frame_of(part), unlimited());
}

TEST(Trace4, EqualsTheChipInPartsWithPatternEverywhere) {
  for (const DemoPart& part : demo_parts())
    if (GoldenWorld(part.first_frame, {}).lock == GoldenLock::Full)
      expect_chip_equals_trace_4(frame_of(part), {});
}

TEST(Trace4, FollowsTheKnobsThatChangeWhatIsMeant) {
  const auto expect_equal_with = [](int knobs::*member, int value, int frame) {
    knobs k = unlimited();
    k.*member = value;
    expect_chip_equals_trace_4(frame, k);
    EXPECT_GT(golden_difference(core_picture(frame, k), golden(Tracer::Trace4, frame)), 0);
  };
  expect_equal_with(&knobs::max_room_depth, 2, 7167);
  expect_equal_with(&knobs::face_stack_depth, 4, 9535);
  expect_equal_with(&knobs::corner_bits, 11, 6400);
  expect_equal_with(&knobs::dithering, DitheringOff, 5119);
  expect_equal_with(&knobs::dithering, DitheringCheckered, 5119);
  expect_equal_with(&knobs::camera_cosine, CosineExact, 1023);
  expect_equal_with(&knobs::bisection, BisectionMidpoint, 9279);
}

// The rule is contract 5.4's; the chip's own residues (contract 11.6) remain, on odd lines.
TEST(Trace4, OddLinesShowThePositionOneStepBack) {
  knobs k = unlimited();
  k.interlace = 1;
  for (const int frame : {200, 1023, 6800, 11263}) {
    const GoldenPicture chip = core_picture(frame, k);
    const GoldenPicture with = golden(Tracer::Trace4, frame, k);
    const GoldenPicture without = golden(Tracer::Trace4, frame, unlimited());
    int residue = 0, unmoved = 0;
    for (std::size_t i = 0; i < chip.size(); ++i) {
      ASSERT_TRUE(i / 640 % 2 || chip[i] == with[i]) << frame << " pixel " << i;
      residue += chip[i] != with[i];
      unmoved += chip[i] != without[i];
    }
    EXPECT_LT(residue, unmoved / 2) << frame;
  }
}

// A test that cannot fail is none: each limit alone is seen. The stack's only at edges that
// chatter: a restart bisects them anew, and otherwise costs time alone.
TEST(Trace4, SeesEveryLimitOfTheChip) {
  const auto expect_seen = [](int knobs::*member, int value, int frame) {
    knobs k = unlimited();
    k.*member = value;
    EXPECT_GT(golden_difference(core_picture(frame, k), golden(Tracer::Trace4, frame, k)), 0)
        << frame;
  };
  const knobs chip;
  expect_seen(&knobs::partial_products_cut, chip.partial_products_cut, 1023);
  expect_seen(&knobs::corner_factor_bits, chip.corner_factor_bits, 1023);
  expect_seen(&knobs::interval_stack_depth, chip.interval_stack_depth, 10032);
  expect_seen(&knobs::clocks_per_pixel, 1, 7167);
  expect_seen(&knobs::interlace, chip.interlace, 1023);
}

// Measured over 1013 frames: 108 pixels (0.035 %) a frame, at most 464; seed: 0.02 to 0.04 %. An
// edge that chatters does so over a few pixels: two thirds of the runs measured are of one, the
// longest 38.
TEST(Trace2, DiffersFromTrace4OnlyWhereAnEdgeChatters) {
  int differing = 0, frames = 0;
  for (const DemoPart& part : demo_parts()) {
    if (has_pattern(part)) continue;
    const GoldenWorld world(frame_of(part), {});
    const GoldenCamera camera(frame_of(part));
    int pixels = 0;
    for (int y = -240; y < 240; ++y) {
      const GoldenRays rays = camera.rays(y);
      const GoldenHits by_pixel = trace_2_line(world, rays, y);
      const GoldenHits by_interval = trace_4_line(world, rays, y);
      for (int p = 0, run = 0; p < VisibleColumns; ++p) {
        run = same_hit(by_pixel[p], by_interval[p]) ? 0 : run + 1;
        pixels += run > 0;
        ASSERT_LT(run, 50) << frame_of(part) << " line " << y << " pixel " << p;
      }
    }
    EXPECT_LT(pixels, 600) << frame_of(part);
    differing += pixels, ++frames;
  }
  EXPECT_GT(differing, 0);
  EXPECT_LT(differing, frames * 640 * 480 / 2000) << "0.05 %";
}

// Trace_2 knows boxes only by ang_leq; geometry only by points. On the same rays they agree.
TEST(Trace2, HitsTheWallThatGeometryHitsWithTheSameRay) {
  for (const DemoPart& part : demo_parts()) {
    const int frame = frame_of(part);
    expect_trace_2_agrees_with_geometry(GoldenWorld(frame, {}), GoldenCamera(frame), 3);
  }
}

// Measured over 1013 frames: 2.0 % of the pixels, at most 5.8 %.
TEST(Geometry, DiffersFromTrace2ByTheCamerasRounding) {
  long differing = 0, frames = 0;
  for (const DemoPart& part : demo_parts()) {
    if (has_pattern(part)) continue;
    const int pixels = golden_difference(golden(Tracer::Trace2, frame_of(part)),
                                         golden(Tracer::Geometry, frame_of(part)));
    EXPECT_LT(pixels, 640 * 480 * 6 / 100) << part.first_frame;
    differing += pixels, ++frames;
  }
  EXPECT_LT(differing, frames * 640 * 480 * 3 / 100);
}

TEST(GoldenPicture, ColumnZeroHasIndexZeroAndPixelsComeOneColumnLate) {
  const GoldenPicture picture = golden(Tracer::Trace2, 1);  // palette 0, shading A
  const GoldenWorld world(1, {});
  const GoldenCamera camera(1);
  const int colours[3] = {0b101011, 0b000110, 0b000001};  // indices 3, 2, 1
  for (int row = 0; row < 480; row += 40) {
    EXPECT_EQ(picture[row * 640], 0);
    const GoldenHits hits = trace_2_line(world, camera.rays(row - 240), row - 240);
    for (int p = 0; p < 639; ++p) ASSERT_EQ(picture[row * 640 + p + 1], colours[hits[p].face]);
  }
}

TEST(GoldenPicture, ABrokenTracerIsNoticed) {
  const int frame = 1023;
  GoldenWorld world(frame, unlimited());
  const GoldenPicture chip = core_picture(frame, unlimited());
  const GoldenCamera camera(frame);
  ASSERT_EQ(golden_difference(chip, golden_picture(Tracer::Trace4, world, camera)), 0);
  const GoldenWorld good = world;
  world.rooms[1].half_size[0] += 1;
  EXPECT_GT(golden_difference(chip, golden_picture(Tracer::Trace4, world, camera)), 0);
  world = good;
  world.rooms[0].position[2] += 1;
  EXPECT_GT(golden_difference(chip, golden_picture(Tracer::Trace4, world, camera)), 0);
  world = good;
  world.room_depth = 3;
  EXPECT_GT(golden_difference(chip, golden_picture(Tracer::Trace4, world, camera)), 0);
  EXPECT_GT(golden_difference(chip, golden_picture(Tracer::Trace4, good, GoldenCamera(frame + 4))),
            0);
}

}  // namespace
}  // namespace racebeam
