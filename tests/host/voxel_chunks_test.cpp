// What is to be built is cut into chunks of frames.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/voxel_chunks.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

voxel_knobs world_of(const vec3& size, const vec3& voxel, int build_chunk) {
  voxel_knobs k;
  k.size_x = size[0], k.size_y = size[1], k.size_z = size[2];
  k.voxel_x = voxel[0], k.voxel_y = voxel[1], k.voxel_z = voxel[2];
  k.build_chunk = build_chunk;
  return k;
}

auto is(int x_low, int y_low, int x_high, int y_high) {
  return testing::AllOf(testing::Field(&voxel_rectangle::x_low, x_low),
                        testing::Field(&voxel_rectangle::y_low, y_low),
                        testing::Field(&voxel_rectangle::x_high, x_high),
                        testing::Field(&voxel_rectangle::y_high, y_high));
}

TEST(VoxelChunks, RectanglesThatFitStayWhole) {
  VoxelChunks chunks(world_of({512, 512, 128}, {1, 4, 1}, 262'144));
  EXPECT_TRUE(chunks.empty());
  EXPECT_THAT(chunks.frame(), IsEmpty());
  chunks.add({0, 0, 512, 512});
  EXPECT_FALSE(chunks.empty());
  EXPECT_THAT(chunks.frame(), ElementsAre(is(0, 0, 512, 512)));
  EXPECT_TRUE(chunks.empty());
}

TEST(VoxelChunks, LargerOnesAreSplitIntoFour) {
  VoxelChunks chunks(world_of({512, 512, 128}, {1, 4, 1}, 262'143));
  chunks.add({0, 0, 512, 512});
  EXPECT_THAT(chunks.frame(),
              ElementsAre(is(0, 0, 256, 256), is(256, 0, 512, 256), is(0, 256, 256, 512)))
      << "a fourth would be a column too much";
  EXPECT_THAT(chunks.frame(), ElementsAre(is(256, 256, 512, 512)));
  EXPECT_TRUE(chunks.empty());
}

TEST(VoxelChunks, TheLongWorldIsSplitThrice) {
  VoxelChunks chunks(world_of({2048, 16384, 256}, {1, 4, 1}, 1'000'000));
  chunks.add({0, 0, 2048, 16384});
  EXPECT_THAT(chunks.frame(), ElementsAre(is(0, 0, 256, 2048)));
  int frames = 1;
  for (; !chunks.empty(); ++frames) EXPECT_THAT(chunks.frame(), SizeIs(1));
  EXPECT_EQ(frames, 64) << "as two of 524,288 columns are more than a chunk";
}

TEST(VoxelChunks, AFrameTakesTenAtMost) {
  VoxelChunks chunks(world_of({64, 64, 32}, {1, 4, 1}, 1'000'000));
  for (int n = 0; n < 12; ++n) chunks.add({n, 0, n + 1, 4});
  EXPECT_THAT(chunks.frame(), SizeIs(10));
  EXPECT_THAT(chunks.frame(), ElementsAre(is(10, 0, 11, 4), is(11, 0, 12, 4)));
}

TEST(VoxelChunks, RectanglesAreAlignedOutwardsToVoxels) {
  VoxelChunks chunks(world_of({64, 64, 32}, {2, 4, 1}, 1'000'000));
  chunks.add({3, 5, 4, 6});
  EXPECT_THAT(chunks.frame(), ElementsAre(is(2, 4, 4, 8)));
}

TEST(VoxelChunks, NoVoxelIsSplit) {
  VoxelChunks chunks(world_of({64, 64, 32}, {2, 4, 1}, 1));
  chunks.add({0, 0, 6, 4});
  EXPECT_THAT(chunks.frame(), ElementsAre(is(0, 0, 2, 4)));
  EXPECT_THAT(chunks.frame(), ElementsAre(is(2, 0, 4, 4)));
  EXPECT_THAT(chunks.frame(), ElementsAre(is(4, 0, 6, 4)));
  EXPECT_TRUE(chunks.empty());
}

TEST(VoxelChunks, EachColumnIsInOneOfThem) {
  for (const int build_chunk : {1, 7, 100, 1000, 4000}) {
    VoxelChunks chunks(world_of({96, 64, 32}, {1, 4, 1}, build_chunk));
    chunks.add({5, 9, 91, 62});
    std::vector<int> built(96 * 64);
    while (!chunks.empty()) {
      int columns = 0;
      for (const voxel_rectangle& r : chunks.frame())
        for (int y = r.y_low; y < r.y_high; ++y)
          for (int x = r.x_low; x < r.x_high; ++x, ++columns)
            ++built[static_cast<std::size_t>(y * 96 + x)];
      EXPECT_LE(columns, std::max(build_chunk, 4)) << "a voxel has four columns";
    }
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 96; ++x)
        ASSERT_EQ(built[static_cast<std::size_t>(y * 96 + x)],
                  x >= 5 && x < 91 && y >= 8 && y < 64 ? 1 : 0)
            << x << "," << y;
  }
}

TEST(VoxelChunks, RefuseWhatIsNotInTheWorld) {
  VoxelChunks chunks(world_of({64, 64, 32}, {1, 4, 1}, 1000));
  EXPECT_THROW(chunks.add({0, 0, 65, 64}), std::invalid_argument);
  EXPECT_THROW(chunks.add({9, 0, 9, 64}), std::invalid_argument);
  EXPECT_TRUE(chunks.empty());
}

}  // namespace
}  // namespace racebeam
