// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>

#include "tb/base/errors.h"
#include "tb/view/view_window.h"

namespace racebeam {
namespace {

TEST(ViewWindowMissing, SaysWhatToInstallAndWhatWorksWithoutIt) {
  try {
    open_window(0);
    FAIL();
  } catch (const MissingTool& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("apt install libsdl2-dev"), std::string::npos);
    EXPECT_NE(what.find("view --term"), std::string::npos);
  }
}

}  // namespace
}  // namespace racebeam
