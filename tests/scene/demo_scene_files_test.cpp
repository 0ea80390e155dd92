// scenes/chip/: each geometry of the demo in a file of its own, with a flight of a whole part.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/camera_path.h"
#include "tests/scene/demo_scene.h"

namespace racebeam {
namespace {

class GeometryFile : public testing::TestWithParam<Geometry> {
 protected:
  GeometryFile() {
    const std::string path =
        std::string(RACEBEAM_SOURCE_DIR "/scenes/chip/") + GetParam().file + ".toml";
    SceneResult result = read_scene_file(path);
    EXPECT_EQ(result.faults.text(path), "");
    scene = std::move(result.scene);
  }

  SceneFile scene;
};

INSTANTIATE_TEST_SUITE_P(Demo, GeometryFile, testing::ValuesIn(Geometries),
                         [](const auto& info) { return std::string(info.param.file); });

TEST_P(GeometryFile, HasTheDemosRooms) {
  const Rooms own = rooms_in_step(scene, GetParam().flags, scene.shots[0].camera.room);
  const Rooms& demos = demo_rooms().at(GetParam().flags);
  EXPECT_EQ(own.size(), scene.rooms.size());
  ASSERT_EQ(own.size(), demos.size());
  for (const auto& [id, room] : own) {
    EXPECT_EQ(scene.rooms[room].centre, demo().rooms[demos.at(id)].centre) << scene.rooms[room].id;
    EXPECT_EQ(scene.rooms[room].half_size, demo().rooms[demos.at(id)].half_size);
  }
}

TEST_P(GeometryFile, LooksAsInTheDemo) {
  const auto chip = choices(GetParam().frame, InsideGate);
  ASSERT_EQ(scene.shots.size(), 1U);
  const Shot& shot = scene.shots[0];
  EXPECT_EQ(shot.look.palette, Palettes[chip.palette]);
  EXPECT_EQ(shot.look.shading == Shading::Dithered, chip.shading_b);
  EXPECT_EQ(shot.look.pattern, Pattern::Off);
  EXPECT_FALSE(shot.look.inverse);
  EXPECT_EQ(shot.camera.interlace, chip.scene_interlace);
  sequencer_core part_0;
  for (part_0.frame_q = 0; part_0.frame_q < scene.frames; ++part_0.frame_q)
    ASSERT_NO_FATAL_FAILURE(expect_turns(scene, part_0, part_0.frame_q));
}

// Contract 17.6: what the demo's longest flights do, also where it flies 256 frames only.
TEST_P(GeometryFile, FliesForAWholePart) {
  const int flags = GetParam().flags;
  const auto chip = choices(GetParam().frame, InsideGate);
  const Rooms rooms = rooms_in_step(scene, flags, scene.shots[0].camera.room);
  const CameraPath path = fly(scene);
  ASSERT_EQ(path.points.size(), 2048U);
  const auto room_at = [&](int j) {
    const int ring = flags & SceneTunnel ? j % 16 : j;
    return scene_core::geometry(flags, ring << 4 | CameraColumn);
  };
  for (int frame = 0, j = 0; frame < scene.frames; ++frame) {
    const int flown = -chip.velocity[2] * std::max(0, frame - 1);
    if (256 * j - flown < -room_at(j).half_size[2]) ++j;
    const vec3 moved = minus(room_at(j).position, room_at(0).position);
    const PathPoint& point = path.points[frame];
    ASSERT_EQ(point.room, rooms.at(j % 16 << 4 | CameraColumn)) << "frame " << frame;
    ASSERT_EQ(point.position[0], -moved[0]) << "frame " << frame;
    ASSERT_EQ(point.position[1], -(chip.start[1] + moved[1])) << "frame " << frame;
    ASSERT_EQ(point.position[2], flown - 256 * j) << "frame " << frame;
  }
}

}  // namespace
}  // namespace racebeam
