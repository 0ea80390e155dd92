// The pictures of one frame with other knobs, in README.md and docs/: their names say which knobs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

TEST(CliKnobPictures, AreWhatTheProgramDraws) {
  const ScratchFolder folder;
  std::set<std::string> pictures;
  for (const auto& entry :
       std::filesystem::directory_iterator(RACEBEAM_SOURCE_DIR "/scenes/pictures")) {
    const std::string name = entry.path().stem();
    if (name.rfind("7223", 0) != 0) continue;
    std::vector<std::string> words = {"render", "demo",  "--first",     "7223",
                                      "--gif",  "a.gif", "--gif-scale", "3"};
    if (name.size() > 5) words.insert(words.end(), {"--set", name.substr(5)});
    Program run(folder.path(), words);
    ASSERT_EQ(run.wait(), 0) << run.err();
    const std::string drawn = read_file(folder / "a.gif");
    EXPECT_TRUE(drawn == read_file(entry.path())) << name << "; scripts/pictures makes it anew";
    pictures.insert(drawn);
  }
  EXPECT_EQ(pictures.size(), 3u) << "each knob is seen";
}

}  // namespace
}  // namespace racebeam
