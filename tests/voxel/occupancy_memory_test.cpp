// Promises of sc/voxel/occupancy_memory.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/occupancy_memory.h"

#include "tests/voxel/memory_claims.h"

namespace racebeam {
namespace {

INSTANTIATE_TYPED_TEST_SUITE_P(Occupancy, VoxelMemory, occupancy_memory);

TEST(OccupancyMemory, HasAWordFor32VoxelsOfEachLevel) {
  voxel_knobs k;
  k.voxel_y = 1;
  EXPECT_EQ(occupancy_memory("dut", k).words().size(), 4720u);
}

}  // namespace
}  // namespace racebeam
