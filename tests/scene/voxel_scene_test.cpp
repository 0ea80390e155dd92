// Scene files of the voxel tracer: what their keys become.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/voxel_scene.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "sc/voxel/voxel_rays.h"
#include "sc/voxel/voxel_world.h"
#include "tb/scene/voxel_terrain.h"
#include "tests/scene/voxel_text.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string Hills = "engine = \"voxel\"\n[terrain]\nfunction = \"hills\"\n";

TEST(VoxelSceneTest, KeysBecomeTheTracersTables) {
  const VoxelText text(R"(engine = "voxel"
frames = 3
[terrain]
function = "canyon"
size = [128, 64, 64]
voxel = [2, 4, 1]
seed = 9
offset = 3
[[material]]
number = 3
low = "#102030"
high = "#405060"
[[crater]]
picture = 1
centre = [200, -10]
radius = 12
depth = 9
[camera]
position = [130.5, -1, 60]
velocity = [1, 2, -0.5]
[light]
direction = [0, 0, 2]
[picture]
size = [320, 200]
)");
  const VoxelProgram program = text.good();
  EXPECT_THAT(program.size, ElementsAre(128, 64, 64));
  EXPECT_THAT(program.voxel, ElementsAre(2, 4, 1));
  EXPECT_EQ(program.columns, canyon_terrain({128, 64, 64}, {9, 3}));
  EXPECT_EQ(program.width, 320);
  EXPECT_EQ(program.height, 200);
  EXPECT_EQ(program.palette[3 * 16], 0x102030);
  EXPECT_EQ(program.palette[3 * 16 + 15], 0x405060);
  EXPECT_EQ(program.palette[3 * 16 + 5], 0x203040);
  ASSERT_EQ(program.craters.size(), 1U);
  EXPECT_EQ(program.craters[0].picture, 1);
  EXPECT_EQ(program.craters[0].x, 200);
  EXPECT_EQ(program.craters[0].y, -10);
  EXPECT_EQ(program.craters[0].radius, 12);
  EXPECT_EQ(program.craters[0].depth, 9);
  ASSERT_EQ(program.views.size(), 3U);
  EXPECT_THAT(program.views[0].origin, ElementsAre(640, 63 * 256, 60 * 256));
  EXPECT_THAT(program.views[2].origin, ElementsAre(4 * 256 + 128, 3 * 256, 59 * 256));
  EXPECT_THAT(program.views[0].light, ElementsAre(0, 0, 65536));
  EXPECT_EQ(text.scene()->counts(), "canyon of 128 x 64 x 64, 1 crater");
  EXPECT_EQ(text.scene()->part(2), "canyon");
  EXPECT_EQ(text.scene()->frames(), 3);
}

TEST(VoxelSceneTest, WithoutKeysItIsAWideWorldFromTheSouth) {
  const VoxelProgram program = VoxelText(Hills).good();
  EXPECT_THAT(program.size, ElementsAre(512, 512, 128));
  EXPECT_THAT(program.voxel, ElementsAre(1, 4, 1));
  EXPECT_EQ(program.columns, hills_terrain({512, 512, 128}, {}));
  EXPECT_EQ(program.views.size(), 120U);
  EXPECT_THAT(program.views[0].origin, ElementsAre(256 * 256, 0, 29491));
  EXPECT_THAT(program.views[119].light, ElementsAre(14301, 28602, 57205));
  EXPECT_EQ(program.width, 640);
  EXPECT_EQ(program.height, 480);
  // The middle of the picture looks north and 20 degrees down.
  const voxel_view& view = program.views[0];
  const double y = view.d00[1] + 320.0 * view.dx[1] + 240.0 * view.dy[1],
               z = view.d00[2] + 320.0 * view.dx[2] + 240.0 * view.dy[2];
  EXPECT_NEAR(std::atan2(-z, y) * 180 / std::acos(-1), 20, 0.1);
}

// Page 5.10, "Picture 64 x 48 of tiny".
TEST(VoxelSceneTest, RawRaysDrawThePictureOfTheVectors) {
  const VoxelProgram program = VoxelText(R"(engine = "voxel"
frames = 1
[terrain]
function = "tiny"
[camera]
position = [32.5, 2.25, 40]
d00 = [-6710880, 10066330, -838866]
dx = [209715, 0, 0]
dy = [0, 0, -209715]
[picture]
size = [64, 48]
)")
                                   .good();
  voxel_knobs k;
  k.size_x = program.size[0];
  k.size_y = program.size[1];
  k.size_z = program.size[2];
  const voxel_world world(voxel_levels(k), program.columns);
  EXPECT_EQ(world.bits_set(), 12409u);
  const voxel_view& view = program.views[0];
  voxel_walked walked;
  std::uint32_t hash = 0x811c9dc5;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      vec3 direction{};
      for (int axis = 0; axis < 3; ++axis)
        direction[axis] = (view.d00[axis] + x * view.dx[axis] + y * view.dy[axis]) >> 8;
      const voxel_end end =
          voxel_walk(world, k, {view.origin, direction}, {k.max_outer, k.max_inner}, walked);
      for (const int each : {static_cast<int>(end.kind), end.position[0] >> 8 & 63,
                             end.position[1] >> 8 & 63, end.position[2] >> 8})
        hash = (hash ^ static_cast<std::uint32_t>(each & 255)) * 0x01000193;
    }
  EXPECT_EQ(walked.clocks, 312737u);
  EXPECT_EQ(hash, 0x8699f15au);
}

TEST(VoxelSceneTest, ShotsGoOnFromWhereTheCameraIs) {
  const VoxelText text(Hills + R"([camera]
position = [100, 50, 120]
velocity = [0, 2, 0]
yaw = { start = 0, step = 4 }
[[shot]]
frame = 10
name = "up"
[shot.camera]
velocity = [0, 0, 1]
[[shot]]
frame = 20
[shot.camera]
position = [7, 8, 99]
yaw = 512
)");
  const VoxelProgram program = text.good();
  EXPECT_THAT(program.views[9].origin, ElementsAre(100 * 256, 68 * 256, 120 * 256));
  EXPECT_THAT(program.views[10].origin, ElementsAre(100 * 256, 70 * 256, 120 * 256));
  EXPECT_THAT(program.views[15].origin, ElementsAre(100 * 256, 70 * 256, 125 * 256));
  EXPECT_THAT(program.views[20].origin, ElementsAre(7 * 256, 8 * 256, 99 * 256));
  EXPECT_THAT(program.views[21].origin, ElementsAre(7 * 256, 8 * 256, 100 * 256));
  EXPECT_EQ(program.views[0].dx[1], 0);
  EXPECT_LT(program.views[15].dx[1], program.views[10].dx[1]);
  EXPECT_EQ(program.views[30].dx[0], 0);  // a quarter turn
  EXPECT_EQ(text.scene()->part(9), "hills");
  EXPECT_EQ(text.scene()->part(12), "up");
  EXPECT_EQ(text.scene()->part(20), "hills");
}

TEST(VoxelSceneTest, PicturesLieBesideTheFile) {
  const ScratchFolder folder;
  std::string pixels = "P2 16 16 255\n";
  for (int n = 0; n < 256; ++n) pixels += std::to_string(n) + "\n";
  std::ofstream(folder / "low.pgm") << pixels;
  const VoxelProgram program = VoxelText(R"(engine = "voxel"
[terrain]
picture = "low.pgm"
size = [16, 16, 256]
voxel = [1, 1, 1]
[camera]
position = [0, 0, 300]
)",
                                         folder.path())
                                   .good();
  ASSERT_EQ(program.columns.size(), 256U);
  EXPECT_EQ(unpacked_column(program.columns[0]).low, 240);  // the last row is the nearest
  EXPECT_EQ(unpacked_column(program.columns[255]).low, 15);
}

const std::string Rooms = R"(frames = 20
[camera]
room = "a"
position = [1, 2, -3]
velocity = [0, 0, 1]
yaw = 100
fov = 120
[[room]]
id = "a"
centre = [10, 0, 20]
half_size = [8, 30, 20]
)";

TEST(VoxelSceneTest, RoomsBringTheirCamera) {
  const ScratchFolder folder;
  std::ofstream(folder / "hall.toml") << Rooms;
  const std::string head =
      "engine = \"voxel\"\n[terrain]\nrooms = \"hall.toml\"\nsize = [64, 64, 128]\n";
  const VoxelProgram program = VoxelText(head, folder.path()).good();
  ASSERT_EQ(program.views.size(), 20U);
  EXPECT_THAT(program.views[0].origin, ElementsAre(11 * 256, 17 * 256, 36 * 256));
  EXPECT_THAT(program.views[3].origin, ElementsAre(11 * 256, 19 * 256, 36 * 256));
  EXPECT_EQ(unpacked_column(program.columns[64 * 20 + 10]).low, 8);
  EXPECT_EQ(unpacked_column(program.columns[64 * 20 + 10]).middle, 68);
  const VoxelProgram other =
      VoxelText(head + "[camera]\nposition = [5, 5, 20]\n", folder.path()).good();
  EXPECT_THAT(other.views[0].origin, ElementsAre(5 * 256, 5 * 256, 20 * 256));
}

TEST(VoxelSceneTest, AFileOfRoomsIsAWorldByItself) {
  const VoxelText text(Rooms + "[for.voxel.terrain]\nsize = [64, 64, 128]\nfloor = 10\n");
  const VoxelProgram program = text.good();
  EXPECT_EQ(text.scene()->counts(), "rooms of 64 x 64 x 128");
  ASSERT_EQ(program.views.size(), 20U);
  EXPECT_THAT(program.views[0].origin, ElementsAre(11 * 256, 17 * 256, 38 * 256));
  EXPECT_EQ(program.objects.size(), 2 * 64U * 64U);
}

TEST(VoxelSceneTest, AFileOfSpheresIsAWorldByItself) {
  const std::string spheres = R"(engine = "sphere"
[eye]
position = [0, 2, -32]
screen = 8
[[sphere]]
id = "red"
centre = [-8, 0, 10]
radius = 4
colour = "#ff0000"
[[sphere]]
centre = [8, 0, 10]
radius = 4
colour = "#0000ff"
[[sphere]]
centre = [0, 0, 20]
radius = 4
colour = "#ff0000"
)";
  const VoxelProgram program =
      VoxelText(spheres + "[for.voxel.terrain]\nsize = [128, 128, 128]\nscale = 2\n").good();
  EXPECT_EQ(program.width, 512);
  EXPECT_EQ(program.height, 480);
  // The lowest point is y = 4, at height 8: y = 2 is at 8 + 2 * 2.
  EXPECT_THAT(program.views[0].origin, ElementsAre(0, 64 * 256, 12 * 256));
  // A unit of the screen a pixel, 256 + 32 away; its middle is on the z axis.
  const voxel_view& view = program.views[0];
  EXPECT_EQ(view.dx[1], 0);
  EXPECT_NEAR(double(view.d00[1]) / view.dx[0], 288, 0.01);
  EXPECT_NEAR(double(view.d00[0]) / view.dx[0], -256, 0.01);
  EXPECT_NEAR(double(view.d00[2]) / view.dx[0], 242, 0.01);
  const voxel_column left = unpacked_column(program.columns[128 * 20 + 112]),
                     right = unpacked_column(program.columns[128 * 20 + 16]),
                     far = unpacked_column(program.columns[128 * 40 + 0]);
  EXPECT_EQ(left.low, 8);
  EXPECT_EQ(left.middle, 8);
  EXPECT_EQ(left.high, 24);
  EXPECT_EQ(left.high_material, far.high_material);
  EXPECT_NE(left.high_material, right.high_material);
  EXPECT_EQ(program.palette[static_cast<std::size_t>(left.high_material * 16 + 15)], 0xff0000);
  EXPECT_EQ(program.palette[static_cast<std::size_t>(right.high_material * 16 + 15)], 0x0000ff);
}

}  // namespace
}  // namespace racebeam
