// rtl/block/block_pkg.sv says what sc/block/codes.h says.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/named_values.h"

namespace racebeam {
namespace {

TEST(BlockPackage, HasTheConstantsOfTheModel) {
  const NamedValues rtl = rtl_constants(source_text("rtl/block/block_pkg.sv"));
  EXPECT_EQ(rtl.size(), 16u);
  expect_model_has(rtl, model_constants(source_text("sc/block/codes.h")));
}

TEST(BlockPackage, HasTheCodesOfTheModel) {
  const auto codes_of = [](const char* file) {
    NamedValues all = codes(source_text(file), "Block");
    for (const auto& [name, value] : model_constants(source_text("sc/block/codes.h")))
      all.erase(name);
    return all;
  };
  const NamedValues rtl = codes_of("rtl/block/block_pkg.sv");
  EXPECT_EQ(rtl.size(), 15u + 7u + 17u);
  EXPECT_EQ(rtl, codes_of("sc/block/codes.h"));
}

}  // namespace
}  // namespace racebeam
