// Worlds that nobody designed: the chip flies and sees what the file says.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "sc/beam/chip_core.h"
#include "tb/golden/golden_picture.h"
#include "tb/scene/scene_compiler.h"
#include "tests/beam/random_scene.h"
#include "tests/support/core_picture.h"
#include "tests/support/unlimited.h"

namespace racebeam {
namespace {

TEST(RandomScenes, AreFlownAsTheFileSays) {
  int crossings = 0, several = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const SceneFile scene = RandomScene(seed).scene();
    const CameraPath path = fly(scene);
    const scene_program program = compile_scene(scene);
    const knobs k = program.fitted({});
    several += program.portals_per_face > 1;
    for (int frame = 0; frame < scene.frames; ++frame) {
      const bool crosses = frame > 0 && path.points[frame].room != path.points[frame - 1].room;
      if (!crosses && frame + 1 < scene.frames) continue;
      crossings += crosses;
      const navigator_core chip = fly_to(frame, k, &program);
      ASSERT_EQ(chip.room_q, path.points[frame].room) << scene.name << ", frame " << frame;
      for (int a = 0; a < 3; ++a)
        ASSERT_EQ(chip.position_q[a], -path.points[frame].position[a])
            << scene.name << ", frame " << frame;
    }
  }
  EXPECT_GT(crossings, 300);
  EXPECT_GT(several, 290);
}

TEST(RandomScenes, WithoutLimitsAreTheIntervalTracerPixelForPixel) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    const SceneFile scene = RandomScene(seed, seed % 2 ? 1200 : 9000).scene();
    const scene_program program = compile_scene(scene);
    ASSERT_EQ(program.corner_bits, seed % 2 ? 12 : 15);
    const knobs k = unlimited(program.fitted({}));
    const int frame = static_cast<int>(seed) % scene.frames;
    const auto golden = golden_picture(
        GoldenTracer::Trace4, GoldenWorld(scene, fly(scene), frame, k), GoldenCamera(scene, frame));
    ASSERT_EQ(golden_difference(core_picture(frame, k, &program), golden), 0)
        << scene.name << ", frame " << frame;
  }
}

}  // namespace
}  // namespace racebeam
