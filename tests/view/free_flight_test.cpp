// The free camera: through portals, along walls, and on the chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/free_flight.h"

#include <gtest/gtest.h>

#include <random>

#include "tb/bench/core_bench.h"
#include "tb/scene/scene_reader.h"
#include "tb/show/show.h"
#include "tb/view/beam_tlm_source.h"

namespace racebeam {
namespace {

// Three rooms in a row to the north, the middle one narrow, and one on top of the first.
constexpr const char* Rooms = R"(
frames = 10
[[room]]
id = "hall"
centre = [0, 0, 0]
half_size = [200, 100, 200]
portals = { north = "door", up = "loft" }
[[room]]
id = "door"
centre = [0, 20, 220]
half_size = [40, 80, 20]
[[room]]
id = "yard"
centre = [0, 0, 440]
half_size = [200, 100, 200]
portals = { south = "door" }
[[room]]
id = "loft"
centre = [0, -150, 0]
half_size = [60, 50, 60]
[camera]
room = "hall"
)";

Show show_of(const std::string& text) {
  SceneResult result = read_scene(text, "test");
  EXPECT_TRUE(result.faults.none()) << result.faults.text("test");
  return {std::move(result.scene), "test"};
}

class FreeFlightTest : public testing::Test {
 protected:
  const Show show = show_of(Rooms);
  const SceneFile& scene = *show.scene();
  FreeFlight fly(const Vector& position, int yaw = 0) const {
    return {scene, {0, position}, {yaw, 0, 96}};
  }
  std::string room(const FreeFlight& flight) const { return scene.rooms[flight.pose().room].id; }
};

TEST_F(FreeFlightTest, AWallStopsTheCameraAndLeavesTheWayAlongIt) {
  FreeFlight flight = fly({100, 0, 0});
  flight.move(500, -50, 0);  // to the north wall, and 50 to the west
  EXPECT_EQ(flight.pose().position, (vec3{50, 0, 194}));
  flight.move(0, 500, 0);
  EXPECT_EQ(flight.pose().position, (vec3{194, 0, 194}));
  EXPECT_EQ(room(flight), "hall");
}

TEST_F(FreeFlightTest, APortalLetsItThroughInTheNextRoomsOwnCoordinates) {
  FreeFlight flight = fly({0, 0, 150});
  flight.move(70, 0, 0);
  EXPECT_EQ(room(flight), "door");
  EXPECT_EQ(flight.pose().position, (vec3{0, -20, 0}));
  flight.move(100, 0, 0);
  EXPECT_EQ(room(flight), "yard");
  EXPECT_EQ(flight.pose().position, (vec3{0, 0, -120}));
  flight.move(-170, 0, 0);
  EXPECT_EQ(room(flight), "hall");
  EXPECT_EQ(flight.pose().position, (vec3{0, 0, 150}));
}

TEST_F(FreeFlightTest, BesideThePortalTheWallHolds) {
  FreeFlight flight = fly({45, 0, 150});
  flight.move(100, 0, 0);
  EXPECT_EQ(room(flight), "hall");
  EXPECT_EQ(flight.pose().position[2], 194);
}

TEST_F(FreeFlightTest, RisesThroughACeilingWindowWhateverItLooksAt) {
  FreeFlight flight = fly({0, 0, 0}, 300);
  flight.turn(0, 200);
  flight.move(0, 0, 130);
  EXPECT_EQ(room(flight), "loft");
  EXPECT_EQ(flight.pose().position, (vec3{0, 20, 0}));
}

TEST_F(FreeFlightTest, GoesWhereItLooks) {
  FreeFlight flight = fly({0, 0, 0}, 0);
  flight.turn(512, 0);
  flight.move(90, 0, 0);
  EXPECT_EQ(flight.pose().position, (vec3{90, 0, 0}));
  flight.turn(-1024, 256);  // west, and down by an eighth of a turn
  flight.move(100, 0, 0);
  EXPECT_EQ(flight.pose().position, (vec3{19, 71, 0}));
  EXPECT_EQ(flight.pose().yaw, 2048 - 512);
}

TEST_F(FreeFlightTest, DoesNotTurnOverItsHead) {
  FreeFlight flight = fly({0, 0, 0});
  flight.turn(0, 5000);
  EXPECT_LT(flight.pose().pitch, 512);
  flight.turn(0, -9000);
  EXPECT_GT(flight.pose().pitch, 2048 - 512);
}

TEST_F(FreeFlightTest, NeverLeavesTheRoomsOnAnyWay) {
  std::mt19937 random(1);
  const auto step = [&](int most) { return static_cast<int>(random() % (2 * most + 1)) - most; };
  FreeFlight flight = fly({0, 0, 0});
  std::vector<bool> seen(scene.rooms.size());
  for (int i = 0; i < 20'000; ++i) {
    flight.turn(step(300), step(100));
    flight.move(step(90), step(60), step(40));
    const Pose pose = flight.pose();
    seen[pose.room] = true;
    for (int a = 0; a < 3; ++a)
      ASSERT_LT(std::abs(pose.position[a]), scene.rooms[pose.room].half_size[a]) << i;
  }
  for (const bool one : seen) EXPECT_TRUE(one);
}

// On the path's own place the free camera shows the path's own frame.
TEST(FreeFlightOnTheChip, FromThePathItShowsTheFrameOfThePath) {
  for (const char* file : {"/scenes/museum.toml", "/scenes/house.toml", "/scenes/demo.toml"}) {
    SceneResult result = read_scene_file(RACEBEAM_SOURCE_DIR + std::string(file));
    const Show show(std::move(result.scene), "test");
    const SceneFile& scene = *show.scene();
    const knobs k = show.standard_knobs();
    TlmSource source(k, show.program(), scene.wrap || scene.overlap);
    for (const int frame : {320, 900}) {
      const PathPoint& point = show.path()->points[frame];
      const GoldenView view = show.golden_camera(frame, {}).view(0);
      ASSERT_TRUE(source.can_fly());
      source.fly(frame, {point.room, point.position, view.yaw, view.pitch, view.fov});
      source.advance(source.clocks_left());
      EXPECT_TRUE(source.watch().screen().colours() ==
                  CoreBench(k, frame, show.program()).picture())
          << file << ' ' << frame;
      EXPECT_EQ(source.watch().frame(), frame);
    }
  }
}

TEST(FreeFlightOnTheChip, EndsWhereThePathGoesOn) {
  SceneResult result = read_scene_file(RACEBEAM_SOURCE_DIR "/scenes/museum.toml");
  const Show show(std::move(result.scene), "test");
  const knobs k = show.standard_knobs();
  TlmSource source(k, show.program(), false);
  source.fly(320, {0, {0, 0, 0}, 0, 0, 96});
  source.advance(source.clocks_left());
  source.seek(480);
  source.advance(source.clocks_left());
  EXPECT_TRUE(source.watch().screen().colours() == CoreBench(k, 480, show.program()).picture());
}

}  // namespace
}  // namespace racebeam
