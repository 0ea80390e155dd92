// The timeline: camera, look and shots, and the camera's way through the rooms.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/camera_path.h"
#include "tests/support/scene_text.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(SceneTimelineTest, WithoutATableAllIsAsOnTheChip) {
  const SceneFile scene = good_scene("plan.storeys = \"@\"\n");
  ASSERT_EQ(scene.shots.size(), 1U);
  const Shot& shot = scene.shots[0];
  EXPECT_EQ(scene.frames, 600);
  EXPECT_EQ(shot.camera.fov.value(0, 0, FocalUnits), 96);
  EXPECT_FALSE(shot.camera.interlace);
  EXPECT_THAT(shot.look.palette, ElementsAre(0, 1, 6, 43));
  EXPECT_EQ(shot.look.shading, Shading::Axis);
  EXPECT_EQ(shot.look.pattern, Pattern::Off);
}

TEST(SceneTimelineTest, LookIsTakenAsWritten) {
  const Look look = good_scene(R"(plan.storeys = "@"
[look]
palette = ["000", "300", "030", "003"]
pattern_palette = [[1, 1, 1], "222", [3, 3, 3], [1, 2, 3]]
shading = "dithered"
pattern = "partial"
inverse = true
)")
                        .shots[0]
                        .look;
  EXPECT_THAT(look.palette, ElementsAre(0, 48, 12, 3));
  EXPECT_THAT(look.pattern_palette, ElementsAre(21, 42, 63, 27));
  EXPECT_EQ(look.shading, Shading::Dithered);
  EXPECT_EQ(look.pattern, Pattern::Partial);
  EXPECT_TRUE(look.inverse);
}

// Contract 7.5: yaw 2 floor(f / 4), pitch 2 (1023 - floor(f / 8)), of 2048.
TEST(SceneTimelineTest, TurnsReachTheChipsAngles) {
  const Camera camera = good_scene(R"(plan.storeys = "@"
[camera]
yaw = { step = 2, every = 4 }
pitch = { start = 2046, step = -2, every = 8 }
fov = { step = 1, every = 2, start = 0, per_line = 1 }
)")
                            .shots[0]
                            .camera;
  for (const int f : {0, 3, 4, 700, 2047, 5000, 12798}) {
    EXPECT_EQ(camera.yaw.value(f, 0, TurnUnits), 2 * (f / 4 % 1024)) << f;
    EXPECT_EQ(camera.pitch.value(f, 0, TurnUnits), 2 * (1023 - f / 8 % 1024)) << f;
    EXPECT_EQ(camera.fov.value(f, 100, FocalUnits), (f / 2 + 100) % 256) << f;
    EXPECT_EQ(camera.fov.value(f, -100, FocalUnits), (f / 2 + 156) % 256) << f;
  }
}

TEST(SceneTimelineTest, ShotsChangeWhatTheyNameAndKeepTheRest) {
  const SceneFile scene = good_scene(R"(plan.storeys = "@"
[camera]
yaw = { step = 4 }
interlace = true
[look]
inverse = true
[[shot]]
frame = 10
camera = { pitch = 7 }
[[shot]]
frame = 20
camera = { yaw = { step = -1 } }
look = { shading = "dithered" }
)");
  ASSERT_EQ(scene.shots.size(), 3U);
  EXPECT_EQ(scene.frames, 620);
  EXPECT_EQ(&scene.shot_at(9), &scene.shots[0]);
  EXPECT_EQ(&scene.shot_at(10), &scene.shots[1]);
  EXPECT_EQ(&scene.shot_at(619), &scene.shots[2]);
  EXPECT_EQ(scene.shots[1].camera.yaw.value(19, 0, TurnUnits), 76) << "the turn goes on";
  EXPECT_EQ(scene.shots[1].camera.pitch.value(19, 0, TurnUnits), 7);
  EXPECT_EQ(scene.shots[2].camera.yaw.value(20, 0, TurnUnits), 80) << "from where it was";
  EXPECT_EQ(scene.shots[2].camera.yaw.value(30, 0, TurnUnits), 70);
  EXPECT_TRUE(scene.shots[2].camera.interlace);
  EXPECT_TRUE(scene.shots[2].look.inverse);
  EXPECT_FALSE(scene.shots[1].restart);
}

TEST(SceneTimelineTest, AShotIsNamedForItselfOnly) {
  const SceneFile scene = good_scene(
      "plan.storeys = \"@\"\n[[shot]]\nframe = 9\nname = \"twist\"\n[[shot]]\nframe = 10\n");
  EXPECT_EQ(scene.shots[0].name, "");
  EXPECT_EQ(scene.shots[1].name, "twist");
  EXPECT_EQ(scene.shots[2].name, "");
}

TEST(SceneTimelineTest, BadShotsAreRefusedWithTheirPlace) {
  const auto expect = [](const std::string& shots, const std::string& fault) {
    EXPECT_THAT(faults_of("frames = 100\nplan.storeys = \"@\"\n" + shots), HasSubstr(fault));
  };
  expect("[[shot]]\n", "f:3:1: 'shot' has no 'frame'");
  expect("[[shot]]\nframe = 0\n", "f:4:9: 'frame' is 0");
  expect("[[shot]]\nframe = 100\n", "f:4:9: the shot is after the end of the scene");
  expect("[[shot]]\nframe = 9\n[[shot]]\nframe = 9\n", "f:6:9: the shot is not after the one");
  expect("[[shot]]\nframe = 9\ncamera = { position = [999, 0, 0] }\n",
         "f:5:23: the camera is outside of its room 'start'");
  expect("[[shot]]\nframe = 9\nlook = { inverse = 1 }\n", "f:5:20: 'inverse' is a whole number");
}

// Contract 13.1: room j and n_z = 256 j - g after g = f - 1 frames of velocity 1.
TEST(SceneTimelineTest, TheCameraFliesAsTheChips) {
  const SceneFile scene = good_scene(
      "frames = 640\n[plan]\nstoreys = \"\"\"\n.\n.\n@\n\"\"\"\n"
      "[camera]\nvelocity = [0, 0, 1]\nposition = [0, 224, 0]\n");
  const CameraPath path = fly(scene);
  ASSERT_EQ(path.points.size(), 640U);
  for (int f = 1; f < 640; ++f) {
    const int g = f - 1, j = (g + 127) / 256;
    EXPECT_EQ(path.points[f].room, number_of(scene, j == 0   ? "start"
                                                    : j == 1 ? "1.2.1"
                                                             : "1.1.1"))
        << f;
    EXPECT_THAT(path.points[f].position, ElementsAre(0, 224, g - 256 * j)) << f;
  }
  EXPECT_EQ(path.points[0].position, path.points[1].position);
}

TEST(SceneTimelineTest, AShotWithARoomRestartsTheFlight) {
  const CameraPath path = fly(good_scene(TwoRooms + R"([[shot]]
frame = 5
camera = { room = "b", velocity = [1, 0, 0] }
)" + "[[shot]]\nframe = 8\ncamera = { position = [3, 2, 1], velocity = [0, 0, 0] }\n"));
  EXPECT_EQ(path.points[4].room, 0);
  EXPECT_EQ(path.points[5].room, 1);
  EXPECT_THAT(path.points[6].position, ElementsAre(0, 0, 0));
  EXPECT_THAT(path.points[7].position, ElementsAre(1, 0, 0));
  EXPECT_EQ(path.points[8].room, 1);
  EXPECT_THAT(path.points[9].position, ElementsAre(3, 2, 1));
}

TEST(SceneTimelineTest, AWallInTheWayIsAFaultOfTheShotThatFlies) {
  const std::string text = TwoRooms + R"([[shot]]
frame = 100
camera = { velocity = [0, 0, 4] }
)";
  EXPECT_THAT(faults_of(text), HasSubstr("f:12:1: in frame 197 the camera leaves 'b' through its "
                                         "north face, which has no portal"));
  good_scene("frames = 197\n" + text);
}

TEST(SceneTimelineTest, TheFrameOfAPortalIsAWall) {
  const std::string text =
      "[plan]\nstoreys = [\"@\", \"h\"]\n[plan.cells]\nh = { hole = true }\n"
      "[camera]\nposition = [100, 0, 0]\nvelocity = [0, -8, 0]\n";
  EXPECT_THAT(faults_of(text), HasSubstr("leaves 'start' through its up face beside its portal"));
}

}  // namespace
}  // namespace racebeam
