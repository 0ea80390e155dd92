// Rooms and spheres as columns, beside the rooms and spheres themselves.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/voxel_solids.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>

#include "sc/sphere/first_hit.h"
#include "sc/voxel/voxel_world.h"
#include "tb/scene/scene_reader.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

constexpr Place At{7, 3};
constexpr vec3 Size{64, 96, 128};

SceneFile rooms_of(const std::string& text) {
  SceneResult result = read_scene(text, "test");
  EXPECT_TRUE(result.faults.none()) << result.faults.text("f");
  return result.scene;
}

const char* const TwoRooms = R"([camera]
room = "a"
[[room]]
id = "a"
centre = [10, 0, 20]
half_size = [8, 30, 20]
portals = { east = "b" }
[[room]]
id = "b"
centre = [26, 10, 20]
half_size = [8, 20, 10]
)";

std::size_t index(int x, int y) { return static_cast<std::size_t>(y * Size[0] + x); }

TEST(VoxelSolidsTest, RoomsAreFloorAndCeilingInASolidWorld) {
  const SceneFile scene = rooms_of(TwoRooms);
  const VoxelMapping map{1, base_of_rooms(scene.rooms, 1, 8), Size};
  EXPECT_EQ(map.base, 38);  // y = 30 is the lowest floor
  Faults faults;
  const VoxelSolids solids = room_columns(scene, map, At, faults);
  EXPECT_EQ(faults.text("f"), "");
  EXPECT_EQ(faults.warnings("f"), "");
  ASSERT_EQ(solids.columns.size(), 64u * 96u);
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 64; ++x) {
      const voxel_column c = unpacked_column(solids.columns[index(x, y)]);
      // In the middle of a column, at every height.
      for (int z = 0; z < 128; ++z) {
        bool open = false;
        for (const Room& room : scene.rooms)
          open = open || (std::abs(x + 0.5 - room.centre[0]) < room.half_size[0] &&
                          std::abs(map.base - (z + 0.5) - room.centre[1]) < room.half_size[1] &&
                          std::abs(y + 0.5 - room.centre[2]) < room.half_size[2]);
        ASSERT_EQ(c.solid(z), !open) << x << " " << y << " " << z;
      }
    }
}

TEST(VoxelSolidsTest, WallsAreNumberedAsTheIntervalTracerDoes) {
  const SceneFile scene = rooms_of(TwoRooms);
  Faults faults;
  const VoxelSolids solids = room_columns(scene, {1, 38, Size}, At, faults);
  const auto lower = [&](int x, int y) { return solids.objects[2 * index(x, y)]; };
  const auto upper = [&](int x, int y) { return solids.objects[2 * index(x, y) + 1]; };
  EXPECT_EQ(lower(10, 20), Down);
  EXPECT_EQ(upper(10, 20), Up);
  EXPECT_EQ(lower(1, 20), West);
  EXPECT_EQ(lower(10, 40), North);
  EXPECT_EQ(lower(18, 3), East);  // beside b
  EXPECT_EQ(lower(26, 20), 12 + Down);
  EXPECT_EQ(lower(34, 20), 12 + East);
  EXPECT_EQ(lower(26, 9), 12 + South);
}

TEST(VoxelSolidsTest, AScaleAppliesToAllOfARoom) {
  const SceneFile scene = rooms_of(TwoRooms);
  Faults faults;
  const VoxelSolids solids = room_columns(scene, {0.5, 20, Size}, At, faults);
  EXPECT_EQ(faults.text("f"), "");
  const voxel_column c = unpacked_column(solids.columns[index(2, 5)]);
  EXPECT_EQ(c.low, 5);
  EXPECT_EQ(c.middle, 35);
  EXPECT_EQ(unpacked_column(solids.columns[index(0, 5)]).low, 128);
}

TEST(VoxelSolidsTest, SeveralStoreysAreRefusedWithTheirRooms) {
  const SceneFile scene = rooms_of(R"([plan]
cell = 16
height = 16
slab = 4
storeys = ["@.", ".#"]
)");
  Faults faults;
  room_columns(scene, {1, 60, Size}, At, faults);
  EXPECT_EQ(faults.count(), 1);
  EXPECT_THAT(faults.text("f"),
              HasSubstr("f:7:3: rooms 'start' and '2.1.1' stand above each other"));
}

TEST(VoxelSolidsTest, RoomsThatDoNotFitAreRefused) {
  const SceneFile scene = rooms_of(TwoRooms);
  Faults high, low, wide;
  room_columns(scene, {3, 100, {256, 256, 128}}, At, high);
  EXPECT_THAT(high.text("f"),
              HasSubstr("room 'a' is from 10 to 190 high; the world from 0 to 128"));
  room_columns(scene, {1, 20, Size}, At, low);
  EXPECT_THAT(low.text("f"), HasSubstr("room 'a' is from -10 to 50 high"));
  EXPECT_THAT(low.text("f"), HasSubstr("make base larger"));
  room_columns(scene, {1, 38, {32, 96, 128}}, At, wide);
  EXPECT_EQ(wide.text("f"), "");
  Faults wider;
  room_columns(scene, {1, 38, {16, 96, 128}}, At, wider);
  EXPECT_THAT(wider.text("f"), HasSubstr("the rooms are 32 wide along x; the world is 16"));
}

TEST(VoxelSolidsTest, WallsOfNoThicknessAreToldOf) {
  SceneFile scene = rooms_of(TwoRooms);
  for (Room& room : scene.rooms)
    for (std::vector<int>& face : room.portals) face.clear();
  Faults faults;
  room_columns(scene, {1, 38, Size}, At, faults);
  EXPECT_TRUE(faults.none());
  EXPECT_THAT(faults.warnings("f"), HasSubstr("rooms 'a' and 'b' touch, and no portal"));
}

std::vector<MovingSphere> three_spheres() {
  std::vector<MovingSphere> spheres(3);
  spheres[0].centre = {-5, 2, 10};
  spheres[0].radius = 4;
  spheres[1].centre = {6.5, -8, 20.25};
  spheres[1].radius = 6;
  spheres[2].centre = {0, 3, 40};
  spheres[2].radius = 2;
  return spheres;
}

TEST(VoxelSolidsTest, SpheresAreAboveAFloor) {
  const std::vector<MovingSphere> spheres = three_spheres();
  const VoxelMapping map{2, base_of_spheres(spheres, 2, 10), Size};
  EXPECT_EQ(map.base, 22);  // y = 6 is the lowest point
  Faults faults;
  const VoxelSolids solids =
      sphere_columns(spheres, {"1", "2", "3"}, {1, 5, 2}, 10, map, At, faults);
  EXPECT_EQ(faults.text("f"), "");
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 64; ++x) {
      const voxel_column c = unpacked_column(solids.columns[index(x, y)]);
      EXPECT_EQ(c.low, 10);
      int object = FirstPlane;
      for (std::size_t n = 0; n < spheres.size(); ++n) {
        const Vector3 centre = map.place(spheres[n].centre);
        const double dx = std::remainder(x + 0.5 - centre[0], 64),
                     dy = std::remainder(y + 0.5 - centre[1], 96), r = 2 * spheres[n].radius;
        const double half2 = r * r - dx * dx - dy * dy;
        if (half2 < 1) continue;
        object = static_cast<int>(n);
        ASSERT_NEAR(c.middle, centre[2] - std::sqrt(half2), 0.51);
        ASSERT_NEAR(c.high, centre[2] + std::sqrt(half2), 0.51);
        ASSERT_EQ(c.high_material, (std::array{1, 5, 2}[n]));
      }
      if (object != FirstPlane) {
        ASSERT_EQ(solids.objects[2 * index(x, y) + 1], object);
      }
      ASSERT_EQ(solids.objects[2 * index(x, y)], FirstPlane);
    }
}

TEST(VoxelSolidsTest, SpheresAboveEachOtherAreRefusedByName) {
  std::vector<MovingSphere> spheres = three_spheres();
  spheres[2].centre = {-4, -20, 13};
  Faults faults;
  sphere_columns(spheres, {"red", "green", "blue"}, {1, 2, 3}, 8, {1, 40, Size}, At, faults);
  EXPECT_EQ(faults.count(), 1);
  EXPECT_THAT(faults.text("f"), HasSubstr("f:7:3: spheres 'red' and 'blue' are above each other"));
  Faults high;
  sphere_columns(three_spheres(), {"red", "green", "blue"}, {1, 2, 3}, 8, {1, 120, Size}, At, high);
  EXPECT_THAT(high.text("f"), HasSubstr("sphere 'green' is up to 134 high"));
}

}  // namespace
}  // namespace racebeam
