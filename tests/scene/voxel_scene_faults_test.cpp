// What scene files of the voxel tracer are refused for: where, what, and what to do.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>

#include "tests/scene/voxel_text.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

/// A world of hills, 64 x 64 x 32, and more lines of [terrain] from line 6 on.
std::string hills(const std::string& more = "") {
  return "engine = \"voxel\"\nframes = 4\n[terrain]\nfunction = \"hills\"\nsize = [64, 64, 32]\n" +
         more;
}

std::string faults_of(const std::string& text, const std::string& folder = "") {
  const VoxelText read(text, folder);
  EXPECT_EQ(read.count() == 0, read.scene() != nullptr);
  return read.faults();
}

/// Of a world whose size, or voxel, is line 4.
std::string faults_of_size(const std::string& line) {
  return faults_of("engine = \"voxel\"\n[terrain]\nfunction = \"hills\"\n" + line + "\n");
}

TEST(VoxelSceneFaultsTest, SidesMustBeMultiplesOfTheLargestVoxel) {
  EXPECT_EQ(faults_of_size("size = [520, 512, 128]"),
            "f:4:8: the world's side along x is 520, no multiple of 128, the side of the largest "
            "voxels\n  help: the next one is 640\n");
  EXPECT_THAT(faults_of_size("size = [512, 510, 128]"),
              HasSubstr("f:4:8: the world's side along y is 510, no multiple of a voxel's 4\n"
                        "  help: the next one is 512"));
}

TEST(VoxelSceneFaultsTest, HeightsArePowersOfTwoUpTo256) {
  for (const char* const height : {"100", "512", "8"})
    EXPECT_EQ(
        faults_of_size("size = [512, 512, " + std::string(height) + "]"),
        "f:4:8: the world is " + std::string(height) + " high\n  help: 16, 32, 64, 128 or 256\n");
}

TEST(VoxelSceneFaultsTest, VoxelsArePowersOfTwoUpTo16) {
  EXPECT_EQ(faults_of_size("voxel = [1, 3, 1]"),
            "f:4:9: a voxel's side along y is 3\n  help: 1, 2, 4, 8 or 16\n");
  EXPECT_EQ(faults_of_size("voxel = [1, 32, 1]"),
            "f:4:13: 'voxel' is 32\n  help: it must be in 1..16\n");
}

TEST(VoxelSceneFaultsTest, AMemoryThatIsTooLargeIsToldWithItsSize) {
  EXPECT_EQ(faults_of_size("size = [16384, 16384, 256]"),
            "f:4:8: the world needs 3.29 GiB: 1.00 for columns and 2.29 for voxels\n"
            "  help: columns have 0.125 GiB, voxels 0.5: make size smaller or voxel larger\n");
}

TEST(VoxelSceneFaultsTest, ATerrainIsMadeFromOneThing) {
  EXPECT_EQ(faults_of("engine = \"voxel\"\n"),
            "f:1:1: the scene has no [terrain]\n"
            "  help: write [terrain] and below it function = \"hills\"\n");
  EXPECT_THAT(faults_of("engine = \"voxel\"\n[terrain]\nsize = [64, 64, 32]\n"),
              HasSubstr("f:2:1: the terrain is made from nothing\n  help: write function"));
  EXPECT_THAT(faults_of(hills("rooms = \"no.toml\"\n")),
              HasSubstr("f:6:9: the terrain is made from 'rooms' too\n  help: leave one of"));
  EXPECT_THAT(faults_of("engine = \"voxel\"\n[terrain]\nfunction = \"hill\"\n"),
              HasSubstr("f:3:12: 'function' is 'hill'\n  help: it must be one of tiny, hills"));
  EXPECT_THAT(faults_of(hills("seeds = 3\n")),
              HasSubstr("f:6:1: unknown key 'seeds' in 'terrain'\n  help: did you mean 'seed'?"));
}

class VoxelPictureFaultsTest : public testing::Test {
 protected:
  /// A picture of 16 x 16 pixels of one grey.
  void make(const std::string& name, int grey, int width = 16) {
    std::string pixels = "P2 " + std::to_string(width) + " 16 255\n";
    for (int n = 0; n < width * 16; ++n) pixels += std::to_string(grey) + "\n";
    std::ofstream(folder_ / name) << pixels;
  }
  /// Of a world of 16 x 16 x 16 from pictures, whose keys are line 5 and below.
  std::string faults(const std::string& keys) {
    return faults_of("engine = \"voxel\"\n[terrain]\nsize = [16, 16, 16]\nvoxel = [1, 1, 1]\n" +
                         keys + "[camera]\nposition = [0, 0, 99]\n",
                     folder_.path());
  }

  ScratchFolder folder_;
};

TEST_F(VoxelPictureFaultsTest, PicturesMustBeThereAndOfTheWorldsSize) {
  make("wide.pgm", 9, 20);
  make("low.pgm", 9);
  std::ofstream(folder_ / "text.png") << "no picture";
  EXPECT_EQ(faults("picture = \"low.pgm\"\n"), "");
  EXPECT_EQ(faults("picture = \"gone.png\"\n"),
            "f:5:11: 'gone.png' cannot be read: there is no such file\n"
            "  help: name a grey picture of 8 or 16 bits that lies beside the scene file\n");
  EXPECT_THAT(faults("picture = \"text.png\"\n"), HasSubstr("f:5:11: 'text.png' cannot be read: "));
  EXPECT_EQ(faults("picture = \"wide.pgm\"\n"),
            "f:5:11: 'wide.pgm' is 20 x 16; the world is 16 x 16\n"
            "  help: write size = [20, 16, 16], or name a picture of the world's size\n");
  EXPECT_THAT(faults("picture = \"low.pgm\"\nmaterials = \"wide.pgm\"\n"),
              HasSubstr("f:6:13: 'wide.pgm' is 20 x 16"));
}

TEST_F(VoxelPictureFaultsTest, LayersDoNotCross) {
  make("a.pgm", 50);
  make("b.pgm", 100);
  make("c.pgm", 200);
  const auto layers = [&](const std::string& low, const std::string& middle,
                          const std::string& high) {
    return faults("picture = \"" + low + ".pgm\"\nmiddle = \"" + middle + ".pgm\"\nhigh = \"" +
                  high + ".pgm\"\n");
  };
  EXPECT_EQ(layers("a", "b", "c"), "");
  EXPECT_THAT(layers("b", "a", "c"),
              HasSubstr("f:6:10: column (0, 0) has low 6, middle 3 and high 13\n  help: none may"));
  EXPECT_THAT(layers("a", "c", "b"), HasSubstr("has low 3, middle 13 and high 6"));
  EXPECT_THAT(faults("picture = \"a.pgm\"\nhigh = \"b.pgm\"\n"),
              HasSubstr("f:6:8: there is 'high' without 'middle'"));
}

TEST(VoxelSceneFaultsTest, TheFocalLengthIsNever0) {
  EXPECT_EQ(faults_of(hills("[camera]\nposition = [1, 1, 40]\nfov = 0\n")),
            "f:7:12: the focal length is 0 in picture 0\n"
            "  help: 'fov' is in pixels: 1..4096; 320 shows a quarter of all around\n");
  EXPECT_THAT(faults_of(hills("[camera]\nposition = [1, 1, 40]\nfov = { start = 2, step = -1 }\n")),
              HasSubstr("the focal length is 0 in picture 2"));
  EXPECT_THAT(faults_of(hills("[camera]\nposition = [1, 1, 40]\nvelocity = [0, 0, -20]\n")),
              HasSubstr("f:7:12: the camera is at height -20 in picture 3"));
}

TEST(VoxelSceneFaultsTest, RaysAreAllGivenAndNotTooLong) {
  const std::string camera = "[camera]\nposition = [1, 1, 40]\n";
  EXPECT_THAT(faults_of(hills(camera + "d00 = [0, 9, 0]\ndx = [1, 0, 0]\n")),
              HasSubstr("f:9:6: of 'd00', 'dx' and 'dy' there are not all"));
  EXPECT_THAT(
      faults_of(hills(camera + "d00 = [0, 9, 0]\ndx = [30000, 0, 0]\ndy = [0, 0, -1]\n")),
      HasSubstr("the ray of pixel (639, 0) is 19170000 along x\n  help: no more than 16777216"));
}

TEST(VoxelSceneFaultsTest, ACameraInTheGroundIsToldOf) {
  const VoxelText read(hills("[camera]\nposition = [1, 1, 3]\nvelocity = [0, 0, -1]\n"));
  EXPECT_EQ(read.faults(), "");
  EXPECT_TRUE(read.scene());
  EXPECT_THAT(read.warnings(), HasSubstr("f:7:12: warning: the camera is inside the ground in "
                                         "picture"));
  EXPECT_THAT(read.warnings(), HasSubstr("help: the picture is that ground"));
}

TEST(VoxelSceneFaultsTest, CratersMaterialsAndTheLightAreChecked) {
  EXPECT_EQ(faults_of(hills("[[crater]]\npicture = 4\ncentre = [3]\nradius = 33\ndepth = 0\n")),
            "f:7:11: the crater is dug after the end of the scene\n"
            "  help: 'frames' is 4; raise it\n"
            "f:8:10: 'centre' is an array\n  help: it must be two whole numbers: [256, 100]\n"
            "f:9:10: the crater is 66 wide; the world is 64\n"
            "  help: make the radius smaller: the world repeats\n"
            "f:10:9: 'depth' is 0\n  help: it must be in 1..255\n");
  EXPECT_THAT(faults_of(hills("[[material]]\nnumber = 8\nlow = \"red\"\n")),
              HasSubstr("f:7:10: 'number' is 8\n  help: it must be in 0..7"));
  EXPECT_THAT(faults_of(hills("[[material]]\nnumber = 1\n[[material]]\nnumber = 1\n")),
              HasSubstr("f:9:10: there are two tables of material 1"));
  EXPECT_THAT(faults_of(hills("[light]\ndirection = [0, 0, 0]\n")),
              HasSubstr("f:7:13: the light comes from nowhere"));
  EXPECT_THAT(faults_of(hills("[picture]\nsize = [4, 500]\n")),
              HasSubstr("f:7:9: 'size' is 4\n  help: it must be in 8..640"));
}

TEST(VoxelSceneFaultsTest, ShotsAreInOrder) {
  EXPECT_THAT(faults_of(hills("[[shot]]\nframe = 2\n[[shot]]\nframe = 2\n")),
              HasSubstr("f:9:9: the shot is not after the one before it"));
  EXPECT_THAT(faults_of(hills("[[shot]]\nframe = 9\n")),
              HasSubstr("f:7:9: the shot is after the end of the scene\n  help: 'frames' is 4"));
}

TEST(VoxelSceneFaultsTest, OtherScenesAreNamedWithTheirFaults) {
  const ScratchFolder folder;
  std::ofstream(folder / "storeys.toml")
      << "[plan]\ncell = 16\nheight = 16\nslab = 4\nstoreys = [\"@.\", \".#\"]\n";
  std::ofstream(folder / "bad.toml") << "[plan]\nstoreys = \"@\"\ncell = 3\n";
  std::ofstream(folder / "stack.toml")
      << "engine = \"sphere\"\n[[sphere]]\nid = \"a\"\ncentre = [0, 0, 9]\nradius = 4\n"
         "[[sphere]]\nid = \"b\"\ncentre = [1, -20, 9]\nradius = 4\n";
  const auto faults = [&](const std::string& line) {
    return faults_of("engine = \"voxel\"\n[terrain]\nsize = [64, 64, 64]\n" + line + "\n",
                     folder.path());
  };
  EXPECT_THAT(faults("rooms = \"storeys.toml\""),
              HasSubstr("f:4:9: rooms 'start' and '2.1.1' stand above each other"));
  EXPECT_THAT(faults("rooms = \"bad.toml\""), HasSubstr("f:4:9: 'bad.toml' has 1 fault: line 3: "));
  EXPECT_THAT(faults("rooms = \"gone.toml\""),
              HasSubstr("f:4:9: 'gone.toml' has 1 fault: cannot be read: No such file"));
  EXPECT_THAT(faults("rooms = \"stack.toml\""),
              HasSubstr("f:4:9: 'stack.toml' is a scene of sphere\n  help: 'rooms' takes one of"));
  EXPECT_THAT(faults("spheres = \"stack.toml\""),
              HasSubstr("f:4:11: spheres 'a' and 'b' are above each other\n  help: a column has"));
}

TEST(VoxelSceneFaultsTest, AFileOfBlockIsRefused) {
  EXPECT_THAT(faults_of("engine = \"block\"\n"),
              HasSubstr("f:1:10: the voxel tracer cannot show a scene of 'block'"));
}

TEST(VoxelSceneFaultsTest, AllFaultsAreTold) {
  const std::string all = faults_of(R"(engine = "voxel"
frames = 0
[terrain]
picture = "gone.png"
size = [500, 512, 128]
[[material]]
low = "#12"
[[crater]]
centre = [1, 2]
radius = 0
[camera]
position = [0, 0]
pitch = "down"
[light]
direction = [0, 0, 0]
[sun]
)");
  for (const char* const place : {"f:2:10: ", "f:4:11: ", "f:5:8: ", "f:6:1: ", "f:8:1: ",
                                  "f:10:10: ", "f:12:12: ", "f:13:9: ", "f:15:13: ", "f:16:2: "})
    EXPECT_THAT(all, HasSubstr(place));
}

}  // namespace
}  // namespace racebeam
