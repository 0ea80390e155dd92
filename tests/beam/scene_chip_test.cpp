// Scene files on the chip: every scene of the folder, against what is independent of the cores.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "sc/beam/chip_core.h"
#include "tb/bench/signal_bench.h"
#include "tb/golden/golden_picture.h"
#include "tb/scene/camera_path.h"
#include "tb/show/show.h"
#include "tests/support/core_picture.h"
#include "tests/support/room_scenes.h"
#include "tests/support/unlimited.h"

namespace racebeam {
namespace {

/// Full pattern shows the rays; partial pattern disturbs the tracer (golden_picture.h).
bool shows_rooms(const GoldenWorld& world) { return world.lock == GoldenLock::None; }

class EveryScene : public testing::TestWithParam<std::string> {};

TEST_P(EveryScene, FliesWhereTheFileSays) {
  const SceneFile scene = room_scene(GetParam());
  const CameraPath path = fly(scene);
  const Show show(scene, "");
  const knobs k = show.standard_knobs();
  ASSERT_EQ(path.points.size(), static_cast<std::size_t>(scene.frames));
  const int step = std::max(1, scene.frames / 300);
  for (int frame = 0; frame < scene.frames; frame += step) {
    const navigator_core chip = fly_to(frame, k, show.program());
    const PathPoint& point = path.points[frame];
    ASSERT_EQ(chip.room_q, point.room) << "frame " << frame;
    for (int a = 0; a < 3; ++a) ASSERT_EQ(chip.position_q[a], -point.position[a]) << frame;
  }
}

/// Compares frames evenly spread over a scene.
void expect_chip_equals_trace_4(const std::string& scene, int samples) {
  const Show show(room_scene(scene), "");
  const knobs k = unlimited(show.standard_knobs());
  int compared = 0;
  for (int i = 0; i < samples; ++i) {
    const int frame = static_cast<int>((2LL * i + 1) * show.frames() / (2 * samples));
    const GoldenWorld world = show.golden_world(frame, k);
    if (!shows_rooms(world)) continue;
    ++compared;
    const auto chip = core_picture(frame, k, show.program());
    const auto golden = golden_picture(GoldenTracer::Trace4, world, show.golden_camera(frame, k));
    ASSERT_EQ(golden_difference(chip, golden), 0) << "frame " << frame;
  }
  EXPECT_GE(compared, samples / 2);
}

TEST_P(EveryScene, WithoutLimitsIsTheIntervalTracerPixelForPixel) {
  expect_chip_equals_trace_4(GetParam(), 5);
}

TEST_P(EveryScene, IsTheSameInSystemCAndInALoop) {
  const Show show(room_scene(GetParam()), "");
  const knobs k = show.standard_knobs();
  SignalBench bench({k, false, false, false, show.program()});
  const int frame = show.frames() / 3;
  bench.seek(frame);
  for (int next = frame; next < frame + 2; ++next)
    EXPECT_EQ(bench.render().picture.colours, core_picture(next, k, show.program())) << next;
}

TEST(LongScenes, WithoutLimitsAreTheIntervalTracerInManyFrames) {
  for (const std::string& name : room_scenes()) expect_chip_equals_trace_4(name, 30);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene, testing::ValuesIn(room_scenes()),
                         [](const auto& info) {
                           std::string name = info.param;
                           std::replace(name.begin(), name.end(), '/', '_');
                           return name;
                         });

}  // namespace
}  // namespace racebeam
