// Promises of sc/voxel/voxel_camera.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_camera.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "tb/twin/unit_bench.h"
#include "tests/voxel/twins.h"

namespace racebeam {
namespace {

template <class Unit>
class VoxelCameraTest : public testing::Test {
 protected:
  void go(bool start, bool line, bool pixel) {
    bench["start_i"].drive(start);
    bench["next_line_i"].drive(line);
    bench["next_pixel_i"].drive(pixel);
    bench.clock();
  }

  Unit unit{"dut"};
  UnitBench bench{unit};
};
TYPED_TEST_SUITE(VoxelCameraTest, voxel_twins<voxel_camera>);

TYPED_TEST(VoxelCameraTest, IsAtEachPixelOfAPicture) {
  std::mt19937 random(4);
  for (int round = 0; round < 4; ++round) {
    std::array<std::array<std::int64_t, 3>, 3> v{};  // d00, dx, dy
    const char* const stems[] = {"d00", "dx", "dy"};
    for (std::size_t n = 0; n < 3; ++n) {
      vec3 value{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        v[n][axis] = value[axis] = static_cast<int>(random()) >> (n ? 8 : 4);
      this->bench.drive(stems[n], "_i", value);
    }
    this->go(true, true, true);
    for (int y = 0; y < 8; ++y) {
      for (int x = 0; x < 40; ++x) {
        const vec3 direction = this->bench.read("direction");
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const std::int64_t d24 = v[0][axis] + x * v[1][axis] + y * v[2][axis];
          ASSERT_EQ(direction[axis], signed_bits(static_cast<std::uint64_t>(d24 >> 8), 18));
        }
        this->go(false, false, false);
        ASSERT_EQ(this->bench.read("direction"), direction) << "stays";
        this->go(false, x == 39, true);
      }
    }
  }
}

}  // namespace
}  // namespace racebeam
