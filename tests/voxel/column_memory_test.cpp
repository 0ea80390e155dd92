// Promises of sc/voxel/column_memory.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/column_memory.h"

#include "tests/voxel/memory_claims.h"

namespace racebeam {
namespace {

INSTANTIATE_TYPED_TEST_SUITE_P(Columns, VoxelMemory, column_memory);

TEST(ColumnMemory, HasAWordForEachColumn) {
  voxel_knobs k;
  k.size_x = 96, k.size_y = 40;
  EXPECT_EQ(column_memory("dut", k).words().size(), 96u * 40);
}

}  // namespace
}  // namespace racebeam
