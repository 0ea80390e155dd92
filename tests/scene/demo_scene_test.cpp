// scenes/demo.toml against the chip: the same rooms, flights, turns and looks in each frame.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/scene/demo_scene.h"

#include "tb/scene/camera_path.h"

namespace racebeam {
namespace {

TEST(DemoScene, RoomsAreTheChips) {
  ASSERT_EQ(demo_rooms().size(), std::size(Geometries));
  std::size_t rooms = 0;
  for (const auto& [flags, own] : demo_rooms()) rooms += own.size();
  EXPECT_EQ(rooms, demo().rooms.size()) << "each room of the file is one of the chip's";
}

TEST(DemoScene, CameraFliesAsTheChips) {
  const CameraPath path = fly(demo());
  ASSERT_EQ(path.points.size(), static_cast<std::size_t>(DemoFrames));
  for (int frame = 0; frame < DemoFrames; ++frame) {
    const navigator_core chip = fly_to(frame, {});
    const int flags = choices(frame, 0).scene_flags;
    const auto room = demo_rooms().at(flags).find(chip.room_q);
    ASSERT_NE(room, demo_rooms().at(flags).end()) << frame;
    const PathPoint& point = path.points[frame];
    ASSERT_EQ(point.room, room->second) << "frame " << frame;
    const vec3 position = {-point.position[0], -point.position[1], -point.position[2]};
    ASSERT_EQ(position, chip.position_q) << "frame " << frame;
  }
}

TEST(DemoScene, CameraTurnsAsTheChips) {
  sequencer_core sequencer;
  for (sequencer.frame_q = 0; sequencer.frame_q < DemoFrames; ++sequencer.frame_q)
    ASSERT_NO_FATAL_FAILURE(expect_turns(demo(), sequencer, sequencer.frame_q));
}

TEST(DemoScene, LookIsTheChips) {
  EXPECT_EQ(demo().frames, DemoFrames);
  EXPECT_EQ(demo().corner_bits, CornerBits);
  for (int frame = 0; frame < DemoFrames; ++frame) {
    const Shot& shot = demo().shot_at(frame);
    const auto inside = choices(frame, InsideGate), outside = choices(frame, OutsideGate);
    ASSERT_EQ(shot.look.pattern, inside.lock    ? Pattern::Full
                                 : outside.lock ? Pattern::Partial
                                                : Pattern::Off)
        << frame;
    ASSERT_EQ(inside.lock ? shot.look.pattern_palette : shot.look.palette, Palettes[inside.palette])
        << frame;
    ASSERT_EQ(outside.lock ? shot.look.pattern_palette : shot.look.palette,
              Palettes[outside.palette])
        << frame;
    ASSERT_EQ(shot.look.shading == Shading::Dithered, inside.shading_b) << frame;
    ASSERT_EQ(shot.look.inverse, inside.inverse) << frame;
    ASSERT_EQ(shot.camera.interlace, inside.scene_interlace) << frame;
    ASSERT_EQ(demo().rooms[shot.camera.room].set, geometry_of(inside.scene_flags).set) << frame;
  }
}

}  // namespace
}  // namespace racebeam
