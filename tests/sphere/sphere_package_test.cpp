// rtl/sphere/sphere_pkg.sv says what sc/sphere/codes.h and sc/store/store_knobs.h say.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/named_values.h"

namespace racebeam {
namespace {

TEST(SpherePackage, HasTheConstantsOfTheModel) {
  const NamedValues rtl = rtl_constants(source_text("rtl/sphere/sphere_pkg.sv"));
  EXPECT_GE(rtl.size(), 18u);
  expect_model_has(rtl, model_constants(source_text("sc/sphere/codes.h") +
                                        source_text("sc/store/store_knobs.h")));
}

TEST(SpherePackage, HasTheCodesOfTheModel) {
  const std::string names = "Sphere|Vector|Shade";
  const NamedValues rtl = codes(source_text("rtl/sphere/sphere_pkg.sv"), names);
  EXPECT_EQ(rtl.size(), 28u + 3u + 8u);
  EXPECT_EQ(rtl, codes(source_text("sc/sphere/codes.h"), names));
}

}  // namespace
}  // namespace racebeam
