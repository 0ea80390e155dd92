// Promises of sc/voxel/voxel_limits.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_limits.h"

#include <gtest/gtest.h>

#include "tb/twin/unit_bench.h"
#include "tests/voxel/twins.h"

namespace racebeam {
namespace {

template <class Unit>
class VoxelLimitsTest : public testing::Test {
 protected:
  bool reached(bool outer, bool inner) {
    bench["start_i"].drive(0);
    bench["outer_i"].drive(outer);
    bench["inner_i"].drive(inner);
    bench.settle();
    const bool now = bench["reached_o"].value();
    bench.clock();
    return now;
  }
  void start(std::uint64_t outer, std::uint64_t inner) {
    bench["max_outer_i"].drive(outer);
    bench["max_inner_i"].drive(inner);
    bench["start_i"].drive(1);
    bench["outer_i"].drive(1);
    bench["inner_i"].drive(1);
    bench.clock();
  }

  Unit unit{"dut"};
  UnitBench bench{unit};
};
TYPED_TEST_SUITE(VoxelLimitsTest, voxel_twins<voxel_limits>);

TYPED_TEST(VoxelLimitsTest, ARayMovesAsOftenAsItMay) {
  for (const int most : {1, 2, 40, 1023}) {
    this->start(static_cast<std::uint64_t>(most), 1);
    for (int move = 0; move < most; ++move) ASSERT_FALSE(this->reached(true, false)) << move;
    EXPECT_TRUE(this->reached(true, false)) << "one more";
    EXPECT_TRUE(this->reached(true, false)) << "it stays at 0";
    EXPECT_FALSE(this->reached(false, false));
  }
}

TYPED_TEST(VoxelLimitsTest, TheLastSampleEndsTheRay) {
  for (const int most : {1, 2, 40, 1023}) {
    this->start(1, static_cast<std::uint64_t>(most));
    for (int sample = 1; sample < most; ++sample)
      ASSERT_FALSE(this->reached(false, true)) << sample;
    EXPECT_TRUE(this->reached(false, true));
    EXPECT_TRUE(this->reached(false, true)) << "it stays at 0";
    EXPECT_FALSE(this->reached(false, false));
  }
}

}  // namespace
}  // namespace racebeam
