// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "sc/knobs.h"

namespace racebeam {
namespace {

TEST(Readme, ListsEveryKnobWithItsDefaultAndRange) {
  std::ifstream file(RACEBEAM_SOURCE_DIR "/README.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(text.empty());
  const knobs defaults;
  for (const auto& row : knob_table()) {
    const std::string line = "| `" + std::string(row.name) + "` | " +
                             row.text(defaults.*row.member) + " | " + row.range() + " | " +
                             row.meaning + " |";
    EXPECT_NE(text.find(line), std::string::npos) << "README.md has no line\n" << line;
  }
}

}  // namespace
}  // namespace racebeam
