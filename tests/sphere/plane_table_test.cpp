// Promises of sc/sphere/plane_table.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/plane_table.h"

#include <gtest/gtest.h>

#include "sc/sphere/sphere_parameters.h"
#include "tb/twin/unit_bench.h"
#include "tests/sphere/four_scene.h"
#include "tests/sphere/twins.h"

namespace racebeam {
namespace {

template <class Unit>
class PlaneTableTest : public testing::Test {};
TYPED_TEST_SUITE(PlaneTableTest, sphere_twins<plane_table>);

TYPED_TEST(PlaneTableTest, PlanesAreReadByIndex) {
  sphere_tables tables = four_tables();
  tables.planes[3].limited = true;
  tables.planes[3].limit = {26, 30, 4000};
  TypeParam unit("dut", tables);
  UnitBench b(unit);
  b["index_i"].drive(1);
  b.settle();
  EXPECT_EQ(b.read("normal"), (vec3{0, -4096, 0}));
  EXPECT_EQ(b["distance_o"].signed_value(), 22 * 4096);
  EXPECT_EQ(b["green_o"].value(), 29u);
  EXPECT_EQ(b["checker_o"].value(), 1u);
  EXPECT_EQ(b["limited_o"].value(), 0u);
  b["index_i"].drive(3);
  b.settle();
  EXPECT_EQ(b["reflect_o"].value(), 0x800u);
  EXPECT_EQ(b["limited_o"].value(), 1u);
  EXPECT_EQ(b["limit_z_o"].value(), 4000u);
  EXPECT_EQ(b["last_o"].value(), 3u);
  EXPECT_EQ(b["empty_o"].value(), 0u);
  b["index_i"].drive(4);
  b.settle();
  EXPECT_EQ(b.read("normal"), (vec3{0, 0, 0})) << "there is none";
}

TYPED_TEST(PlaneTableTest, SceneWithoutPlanesSaysSo) {
  const sphere_tables tables;
  TypeParam unit("dut", tables);
  UnitBench b(unit);
  b.settle();
  EXPECT_EQ(b["empty_o"].value(), 1u);
  EXPECT_EQ(b["last_o"].value(), 0u);
}

TEST(PlaneFileRow, HasTheDigitsOfTheContract) {
  plane_row plane{{0, -4096, 1}, -1, {31, 2, 3}, 0x800, 5, true, {1, 30, 4000}};
  EXPECT_EQ(plane_file_row(plane), "000000fff000000001ffffff1f02038005100101efa0");
}

}  // namespace
}  // namespace racebeam
