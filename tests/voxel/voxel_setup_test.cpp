// Promises of sc/voxel/voxel_setup.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_setup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "sc/voxel/numbers.h"
#include "tb/twin/unit_bench.h"
#include "tests/voxel/twins.h"

namespace racebeam {
namespace {

template <class Unit>
class VoxelSetupTest : public testing::Test {
 protected:
  VoxelSetupTest() {
    bench.clock(2);
    bench["rst_ni"].drive(1);
  }
  /// From the start to the end; done_o is 1 in the last of 16 clocks alone.
  void divide(const vec3& direction) {
    bench.drive("direction", "_i", direction);
    for (int clock = 0; clock < 16; ++clock) {
      bench["start_i"].drive(clock == 0);
      bench.settle();
      ASSERT_EQ(bench["done_o"].value(), clock == 15 ? 1u : 0u) << "clock " << clock;
      bench.clock();
    }
    ASSERT_EQ(bench["done_o"].value(), 0u);
  }
  void expect_inverses(const vec3& direction) {
    ASSERT_NO_FATAL_FAILURE(divide(direction));
    const char* const ports[] = {"inverse_x_o", "inverse_y_o", "inverse_z_o"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::int64_t size = std::abs(direction[axis]);
      const std::uint64_t all = std::uint64_t{1} << 36, most = 0xffffffff;
      const std::uint64_t inverse =
          size < 16 ? 0 : std::min(all / static_cast<std::uint64_t>(size), most);
      ASSERT_EQ(bench[ports[axis]].value(), inverse) << "of " << direction[axis];
      ASSERT_EQ(voxel_inverse(direction[axis]), inverse);
      ASSERT_EQ(bench["parallel_o"].value() >> axis & 1, size < 16 ? 1u : 0u);
    }
  }

  Unit unit{"dut"};
  UnitBench bench{unit};
};
TYPED_TEST_SUITE(VoxelSetupTest, voxel_twins<voxel_setup>);

TYPED_TEST(VoxelSetupTest, FindsInversesAtTheEndsOfTheirRange) {
  this->expect_inverses({16, -16, 17});
  this->expect_inverses({15, -15, 0});
  this->expect_inverses({65536, -65536, 65535});
  this->expect_inverses({131071, -131072, 1});
}

TYPED_TEST(VoxelSetupTest, FindsInversesOfAnyDirection) {
  std::mt19937 random(3);
  const auto part = [&] {
    return std::uniform_int_distribution(-131072, 131071)(random) >> random() % 14;
  };
  for (int n = 0; n < 1000; ++n) this->expect_inverses({part(), part(), part()});
}

TYPED_TEST(VoxelSetupTest, AResetEndsADivision) {
  this->bench.drive("direction", "_i", {100, 200, 300});
  this->bench["start_i"].drive(1);
  this->bench.clock();
  this->bench["start_i"].drive(0);
  this->bench.clock(5);
  this->bench["rst_ni"].drive(0);
  this->bench.clock();
  this->bench["rst_ni"].drive(1);
  for (int clock = 0; clock < 20; ++clock) {
    ASSERT_EQ(this->bench["done_o"].value(), 0u);
    this->bench.clock();
  }
  this->expect_inverses({100, 200, 300});
}

}  // namespace
}  // namespace racebeam
