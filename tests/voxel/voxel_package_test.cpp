// rtl/voxel/voxel_pkg.sv says what sc/voxel/codes.h says.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/named_values.h"

namespace racebeam {
namespace {

TEST(VoxelPackage, HasTheConstantsOfTheModel) {
  const NamedValues rtl = rtl_constants(source_text("rtl/voxel/voxel_pkg.sv"));
  EXPECT_EQ(rtl.size(), 42u);
  expect_model_has(rtl, model_constants(source_text("sc/voxel/codes.h")));
}

TEST(VoxelPackage, HasTheCodesOfTheModel) {
  const auto codes_of = [](const char* file) {
    NamedValues all = codes(source_text(file), "Voxel");
    for (const auto& [name, value] : model_constants(source_text("sc/voxel/codes.h")))
      all.erase(name);
    return all;
  };
  const NamedValues rtl = codes_of("rtl/voxel/voxel_pkg.sv");
  EXPECT_EQ(rtl.size(), 8u + 4u + 4u + 4u);
  EXPECT_EQ(rtl, codes_of("sc/voxel/codes.h"));
}

}  // namespace
}  // namespace racebeam
