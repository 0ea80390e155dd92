// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "sc/base/knobs.h"
#include "tb/scene/scene_keys.h"
#include "tb/scene/scene_reader.h"

namespace racebeam {
namespace {

std::string readme() {
  std::ifstream file(RACEBEAM_SOURCE_DIR "/README.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Readme, ListsEveryKeyOfSceneFiles) {
  const std::string text = readme();
  for (const SceneKey& key : scene_keys())
    EXPECT_NE(text.find("\n" + key_row(key) + "\n"), std::string::npos) << key_row(key);
}

TEST(Readme, ExampleSceneIsGood) {
  const std::string text = readme();
  const auto begin = text.find("```toml\n") + 8;
  const auto end = text.find("```", begin);
  ASSERT_LT(begin, end);
  const SceneResult result = read_scene(text.substr(begin, end - begin), "example");
  EXPECT_TRUE(result.faults.none()) << result.faults.text("README.md");
  EXPECT_EQ(result.scene.rooms.size(), 22u);
}

TEST(Readme, ListsEveryKnobWithItsDefaultAndRange) {
  const std::string text = readme();
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
