// What is checked of a scene as a whole, and how fast; the widths that its chip needs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/scene_check.h"

#include <chrono>
#include <random>

#include "tb/scene/camera_path.h"
#include "tb/scene/scene_sight.h"
#include "tests/support/scene_text.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

// A row of `count` cells of 256 to the north; the camera is in the south.
std::string row(int count) {
  std::string text = "[plan]\nstoreys = \"\"\"\n";
  for (int i = 1; i < count; ++i) text += ".\n";
  return text + "@\n\"\"\"\n";
}

// [[room]] tables of a grid without portals, `apart` from centre to centre.
std::string grid(int side, int apart) {
  std::string text = "[camera]\nroom = \"0,0\"\n";
  for (int x = 0; x < side; ++x)
    for (int z = 0; z < side; ++z) {
      text += "[[room]]\nid = \"" + std::to_string(x) + "," + std::to_string(z) + "\"\n";
      text +=
          "centre = [" + std::to_string(x * apart) + ", 0, " + std::to_string(z * apart) + "]\n";
      text += "half_size = [128, 128, 128]\n";
      if (x > 0 && apart == 256)
        text +=
            "portals = { west = \"" + std::to_string(x - 1) + "," + std::to_string(z) + "\" }\n";
    }
  return text;
}

// Generous: the promise is a second; sanitizers and busy machines are slower.
void expect_soon(std::chrono::steady_clock::time_point start) {
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

TEST(SceneCheckTest, WidthsFollowFromTheScene) {
  const SceneFile one = good_scene("plan.storeys = \"@\"\n");
  const SceneWidths widths = scene_widths(one);
  EXPECT_EQ(widths.room_bits, 1) << "room 0, and 1 for solid";
  EXPECT_EQ(widths.corner_bits, 11) << "512 high: -1024..1023";
  EXPECT_EQ(widths.camera_bits, 1) << "it stays at 0";
  EXPECT_EQ(widths.portals_per_face, 0);
  EXPECT_EQ(deepest_view(one), 0);
}

TEST(SceneCheckTest, CornerBitsCountNinePassedRooms) {
  const SceneFile seven = good_scene(row(7)), eight = good_scene(row(8)),
                  many = good_scene(row(30));
  EXPECT_EQ(scene_widths(seven).corner_bits, 12) << "1792";
  EXPECT_EQ(scene_widths(eight).corner_bits, 13) << "2048 does not fit -2048..2047";
  EXPECT_EQ(farthest_corner(many).distance, 9 * 256) << "the camera's room and eight more";
  EXPECT_EQ(deepest_view(seven), 6);
  EXPECT_EQ(deepest_view(many), 8);
}

TEST(SceneCheckTest, CornerBitsOfTheFileAreALimit) {
  EXPECT_THAT(faults_of("corner_bits = 12\n" + row(9)),
              HasSubstr("is 2304 away; 12 corner bits reach to 2047"));
  const SceneFile wraps = good_scene("corner_bits = 12\nwrap = true\n" + row(9));
  EXPECT_EQ(built_corner_bits(wraps, scene_widths(wraps)), 12);
  const SceneFile wide = good_scene("corner_bits = 14\n" + row(9));
  EXPECT_EQ(built_corner_bits(wide, scene_widths(wide)), 14);
  EXPECT_THAT(faults_of("plan.cell = 8192\n" + row(9).substr(7)), HasSubstr("storeys"));
}

TEST(SceneCheckTest, RoomsThatNoWidthHoldsAreRefused) {
  const std::string text = "plan.cell = 8192\nplan.opening = 2\nplan.storeys = \"@........\"\n";
  EXPECT_THAT(faults_of(text), HasSubstr("16 corner bits reach to 32767"));
  good_scene("wrap = true\n" + text);
}

// The navigator adds half a room to the camera's place, a step behind the face.
TEST(SceneCheckTest, CornerBitsCoverTheCameraBehindTheFaceOfALargeRoom) {
  const std::string flight = R"(frames = 600
[camera]
room = "a"
position = [1000, 0, 0]
velocity = [9, 0, 0]
[[room]]
id = "a"
centre = [0, 0, 0]
half_size = [1022, 9, 9]
portals = { east = "b" }
[[room]]
id = "b"
centre = [1052, 0, 0]
half_size = [30, 9, 9]
[[shot]]
frame = 4
camera = { velocity = [0, 0, 0] }
)";
  EXPECT_EQ(fly(good_scene(flight)).reach, 1027 + 1022);
  EXPECT_THAT(
      faults_of("corner_bits = 12\nwrap = true\n" + flight),
      HasSubstr("9:6: the camera cannot fly in 'a': its place and half the room add to 2049; 12 "
                "corner bits reach to 2047"));
  good_scene("corner_bits = 13\nwrap = true\n" + flight);
}

TEST(SceneCheckTest, CameraBitsCoverTheWay) {
  const SceneFile scene =
      good_scene("frames = 257\n" + row(2) + "[camera]\nvelocity = [0, 0, 1]\n");
  EXPECT_EQ(scene_widths(scene).camera_bits, 9) << "129 before it changes the room";
}

TEST(SceneCheckTest, MoreRoomsThanNumbersAreRefused) {
  const std::string big = "plan.cell = 2\nplan.opening = 2\nplan.storeys = \"\"\"\n@";
  EXPECT_THAT(faults_of(big + std::string(8191, '.') + "\n\"\"\"\n"),
              HasSubstr("the plan has 8192 rooms"));
  EXPECT_EQ(scene_widths(good_scene(big + std::string(8190, '.') + "\n\"\"\"\n")).room_bits, 13);
}

TEST(SceneCheckTest, FourThousandRoomsAreCheckedSoon) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(good_scene(grid(64, 256)).rooms.size(), 4096U);
  std::string open = "[plan]\nstoreys = \"\"\"\n";
  for (int r = 0; r < 64; ++r) open += (r ? "." : "@") + std::string(63, '.') + "\n";
  EXPECT_EQ(good_scene(open + "\"\"\"\n").rooms.size(), 4096U);
  expect_soon(start);
}

TEST(SceneCheckTest, FourThousandOverlapsAreFoundSoon) {
  const auto start = std::chrono::steady_clock::now();
  const SceneResult result = read_scene(grid(64, 1), "test");
  EXPECT_EQ(result.faults.count(), 4095) << "each room but the first";
  expect_soon(start);
}

TEST(SceneCheckTest, FourThousandUnknownPortalsAreFoundSoon) {
  const auto start = std::chrono::steady_clock::now();
  std::string text = grid(64, 256);
  for (std::size_t at = 0; (at = text.find("west = \"", at)) != std::string::npos; ++at)
    text.replace(at, 8, "west = \"x");
  EXPECT_EQ(read_scene(text, "test").faults.count(), 63 * 64);
  expect_soon(start);
}

// Against all pairs, on random boxes.
TEST(SceneCheckTest, OverlapsAreThoseOfAllPairs) {
  std::mt19937 random(3);
  for (int run = 0; run < 50; ++run) {
    SceneFile scene;
    for (int i = 0; i < 30; ++i) {
      Room room;
      for (int axis = 0; axis < 3; ++axis) {
        room.centre[axis] = static_cast<int>(random() % 100);
        room.half_size[axis] = 1 + static_cast<int>(random() % 15);
      }
      room.set = random() % 2 ? "a" : "b";
      scene.rooms.push_back(room);
    }
    int expected = 0;
    for (std::size_t b = 0; b < scene.rooms.size(); ++b) {
      bool any = false;
      for (std::size_t a = 0; a < b; ++a)
        any |= scene.rooms[a].set == scene.rooms[b].set &&
               rooms_overlap(scene.rooms[a], scene.rooms[b]);
      expected += any;
    }
    Faults faults;
    check_rooms(scene, faults);
    EXPECT_EQ(faults.count(), expected) << run;
  }
}

}  // namespace
}  // namespace racebeam
