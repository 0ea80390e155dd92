// The golden tracers on scene files: portals, places, and what they say of each other.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/golden/golden_scene_bench.h"

namespace racebeam {
namespace {

using Tracer = GoldenTracer;

// A hall whose north wall, 256 ahead of the camera, has an opening to either side of its middle:
// x = -192..-64 to a niche 64 deep, x = 64..192 to a corridor 512 long, both y = -64..64. With a
// focal length of 160 the ray of pixel p and line y reaches the north wall at x = 1.6 (p - 320),
// y' = 1.6 y, and the niche's end, 320 ahead, at twice p - 320 and y.
std::string two_openings(const std::string& order) {
  return "[camera]\nroom = \"hall\"\nfov = 160\n" +
         room("hall", "0, 0, 0", "256, 128, 256", "north = [" + order + "]") +
         room("niche", "-128, 0, 288", "64, 64, 32") +
         room("corridor", "128, 0, 512", "64, 64, 256");
}

TEST(ScenePortals, ARayEntersTheRoomBehindTheOpeningThatItGoesThrough) {
  const struct {
    int pixel, y, face;
    bool negative;
  } rays[] = {
      {260, 0, 2, false},    // x = -96 through the left opening: the niche's end
      {210, 0, 0, true},     // x = -176; at the niche's end it would be -220: its west wall
      {270, 38, 1, false},   // x = -80, y' = 61; at the end y' would be 76: the niche's floor
      {270, -38, 1, true},   // its ceiling
      {400, 0, 0, false},    // x = 128 through the right opening; 192 at 384: its east wall
      {400, 38, 1, false},   // y' = 61; 64 at 269, where x = 135: the corridor's floor
      {320, 38, 2, false},   // x = 0, y' = 61: the wall between, though on the openings' height
      {180, 38, 2, false},   // x = -224: the wall west of the niche
      {460, 38, 2, false},   // x = 224: the wall east of the corridor
      {270, 45, 2, false},   // x = -80, y' = 72: the wall below the left opening
      {400, -45, 2, false},  // x = 128, y' = -72: the wall above the right opening
      {500, 0, 0, false},    // x would be 288: the hall's east wall
      {400, 90, 1, false},   // y' would be 144: the hall's floor
  };
  for (const std::string order : {"\"niche\", \"corridor\"", "\"corridor\", \"niche\""}) {
    const GoldenScene shown(two_openings(order));
    for (const auto& ray : rays)
      for (const Tracer tracer : GoldenTracers) {
        const GoldenHit hit = shown.hit(tracer, ray.pixel, ray.y);
        EXPECT_EQ(hit.face, ray.face) << ray.pixel << " " << ray.y << " " << order;
        EXPECT_EQ(hit.negative, ray.negative) << ray.pixel << " " << ray.y << " " << order;
      }
  }
}

TEST(ScenePortals, TheOrderOfOpeningsThatDoNotOverlapDoesNotMatter) {
  const GoldenScene one(two_openings("\"niche\", \"corridor\""));
  const GoldenScene other(two_openings("\"corridor\", \"niche\""));
  for (const Tracer tracer : GoldenTracers)
    EXPECT_EQ(one.picture(tracer, 0), other.picture(tracer, 0)) << static_cast<int>(tracer);
}

// Two rooms behind the same opening, x = -160..160. The ray of pixel 360 is at x = 80 where the
// short one ends, 320 ahead; in the long one it meets the east wall, x = 160, at 640.
TEST(ScenePortals, OfOpeningsThatOverlapTheFirstIsEntered) {
  const auto face = [](const std::string& order, Tracer tracer) {
    const GoldenScene shown("overlap = true\n[camera]\nroom = \"hall\"\nfov = 160\n" +
                            room("hall", "0, 0, 0", "256, 128, 256", "north = [" + order + "]") +
                            room("short", "0, 0, 288", "160, 64, 32") +
                            room("long", "0, 0, 768", "160, 64, 512"));
    return shown.hit(tracer, 360, 0).face;
  };
  for (const Tracer tracer : GoldenTracers) {
    EXPECT_EQ(face("\"short\", \"long\"", tracer), 2);
    EXPECT_EQ(face("\"long\", \"short\"", tracer), 0);
  }
}

// The room behind the opening begins at 512, twice as far as the hall's wall; its near face is x =
// -64..64, y = -64..64, and 640 is its end. There the ray of pixel p is at x = 3.2 (p - 320), y' =
// 3.2 y and at 4 (p - 320), 4 y.
TEST(ScenePortals, AnOpeningIsTheNearFaceOfTheRoomBehindWhereverThatIs) {
  const GoldenScene shown("overlap = true\n[camera]\nroom = \"hall\"\nfov = 160\n" +
                          room("hall", "0, 0, 0", "256, 128, 256", "north = \"far\"") +
                          room("far", "0, 0, 576", "64, 64, 64"));
  for (const Tracer tracer : GoldenTracers) {
    EXPECT_EQ(shown.hit(tracer, 335, 15).face, 2) << "x = 60, y' = 60 at its end";
    EXPECT_EQ(shown.hit(tracer, 335, 18).face, 1) << "y' = 58, at its end 72: its floor";
    EXPECT_EQ(shown.hit(tracer, 338, 15).face, 0) << "x = 58, at its end 72: its east wall";
    EXPECT_EQ(shown.hit(tracer, 345, 18).face, 2) << "x = 80 is outside";
    EXPECT_EQ(shown.hit(tracer, 335, 25).face, 2) << "y' = 80 is outside";
  }
}

// The room behind the north wall begins at -128, behind the camera. Lengthened backwards, the ray
// of pixel 390 would go through that face, at x = -56, and then hit the room's east wall.
TEST(ScenePortals, AnOpeningBehindTheCameraIsNone) {
  const GoldenScene shown("overlap = true\n[camera]\nroom = \"hall\"\nfov = 160\n" +
                          room("hall", "0, 0, 0", "256, 128, 256", "north = \"long\"") +
                          room("long", "0, 0, 100", "64, 64, 228"));
  for (const Tracer tracer : GoldenTracers) EXPECT_EQ(shown.hit(tracer, 390, 0).face, 2);
}

// A ray enters max_room_depth rooms; openings that it misses do not count.
TEST(ScenePortals, MissedOpeningsDoNotCountAsDepth) {
  GoldenScene shown(two_openings("\"niche\", \"corridor\""));
  shown.k.max_room_depth = 1;
  for (const Tracer tracer : GoldenTracers) EXPECT_EQ(shown.hit(tracer, 400, 0).face, 0);
  shown.k.max_room_depth = 0;
  for (const Tracer tracer : GoldenTracers) EXPECT_EQ(shown.hit(tracer, 400, 0).face, 2);
}

// Contract 12.1 and 13.1 as a scene file: the first part of the demo.
std::string demo_as_scene() {
  std::string text = R"(frames = 2048
corner_bits = 12
wrap = true
[camera]
room = "0.0.4"
position = [0, 224, 0]
velocity = [0, 0, 1]
yaw = { step = 2, every = 4 }
pitch = { start = -2, step = -2, every = 8 }
interlace = true
)";
  const auto id = [](int k, int j, int i) {
    return std::to_string(k) + "." + std::to_string(j) + "." + std::to_string(i);
  };
  for (int j = 0; j < 9; ++j)
    for (int i = 0; i < 9; ++i) {
      if (i % 2 && j % 2) continue;  // a pillar
      const std::string x = std::to_string(256 * i), z = std::to_string(256 * j);
      std::string portals = "up = \"" + id(1, j, i) + "\"";
      if (j % 2 == 0 && i < 8) portals += ", east = \"" + id(0, j, i + 1) + "\"";
      if (i % 2 == 0 && j < 8) portals += ", north = \"" + id(0, j + 1, i) + "\"";
      text += room(id(0, j, i), x + ", 0, " + z, "128, 256, 128", portals);
      text += room(id(1, j, i), x + ", -272, " + z, "96, 16, 96");
    }
  return text;
}

TEST(SceneWorld, TheDemoWrittenAsASceneLooksLikeTheDemo) {
  const GoldenScene shown(demo_as_scene());
  for (const int frame : {0, 1, 129, 130, 700, 1023, 1922, 2047})
    for (const Tracer tracer : GoldenTracers)
      EXPECT_EQ(shown.picture(tracer, frame),
                golden_picture(tracer, GoldenWorld(frame, shown.k), GoldenCamera(frame)))
          << frame;
}

// Sixteen rooms of 256 are the whole range of 12 bits: the last touches the first. Wide and narrow
// rooms alternate, so that the view repeats after two rooms, 32 frames.
std::string ring() {
  std::string text =
      "overlap = true\nwrap = true\ncorner_bits = 12\nframes = 600\n[camera]\nroom = \"0\"\n"
      "velocity = [0, 0, 16]\nfov = 160\npitch = 60\n";
  for (int i = 0; i < 16; ++i)
    text += room(std::to_string(i), "0, 0, " + std::to_string(256 * i),
                 i % 2 ? "96, 96, 128" : "128, 128, 128",
                 "north = \"" + std::to_string((i + 1) % 16) + "\"");
  return text;
}

TEST(SceneWorld, ATunnelThatClosesOnItselfHasNoSeam) {
  const GoldenScene shown(ring());
  ASSERT_EQ(shown.path.points.size(), 600U) << "flies round twice";
  for (const Tracer tracer : GoldenTracers) {
    const GoldenPicture first = shown.picture(tracer, 65);
    EXPECT_NE(first, shown.picture(tracer, 65 + 16)) << "a narrow room";
    for (const int frame : {65 + 96, 65 + 128, 65 + 160, 65 + 192, 65 + 512})
      EXPECT_EQ(first, shown.picture(tracer, frame)) << frame;
  }
}

TEST(SceneWorld, RoomsOfAWrappedTunnelTouchAcrossItsSeam) {
  GoldenScene shown(ring());
  const auto gaps = [&](int frame) {
    const GoldenWorld world = shown.world(frame);
    int gaps = 0;
    for (const GoldenRoom& from : world.rooms)
      for (const int to : from.neighbours[golden_face(2, false)]) {
        const GoldenRoom& next = world.rooms[to];
        gaps += from.position[2] + from.half_size[2] != next.position[2] - next.half_size[2];
      }
    return gaps;
  };
  EXPECT_EQ(gaps(200), 0);
  EXPECT_EQ(shown.world(200).rooms.size(), 17U) << "eight ahead, eight behind";
  shown.k.corner_bits = 13;
  EXPECT_GT(gaps(200), 0) << "built too wide";
}

}  // namespace
}  // namespace racebeam
