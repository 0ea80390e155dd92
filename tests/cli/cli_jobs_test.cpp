// `racebeam render --jobs`: several processes leave what one leaves.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

class CliJobsTest : public testing::Test {
 protected:
  void render(const std::string& to, std::vector<std::string> more) {
    std::vector<std::string> arguments = {"render", "demo", "-o", to};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Program program(folder.path(), arguments);
    ASSERT_EQ(program.wait(), 0) << program.err();
    tables[to] = program.out();
  }
  /// Both folders have the same files; the manifest tells of the command.
  void expect_equal_folders(const std::string& a, const std::string& b) {
    std::vector<std::string> names[2];
    for (const int side : {0, 1}) {
      for (const auto& entry : fs::directory_iterator(folder / (side == 0 ? a : b)))
        names[side].push_back(entry.path().filename());
      std::sort(names[side].begin(), names[side].end());
    }
    ASSERT_EQ(names[0], names[1]);
    EXPECT_EQ(tables[a], tables[b]);
    for (const std::string& name : names[0]) {
      if (name == "manifest.json") continue;
      EXPECT_TRUE(read_file(folder / (a + "/" + name)) == read_file(folder / (b + "/" + name)))
          << name;
    }
  }

  ScratchFolder folder;
  std::map<std::string, std::string> tables;
};

// More frames than a process renders in a row, over the end of the demo.
TEST_F(CliJobsTest, SeveralProcessesLeaveTheFilesOfOne) {
  const auto run = [&](const std::string& to, const char* jobs) {
    render(to, {"--first", "12790", "--frames", "20", "--crc", "--wav", to + ".wav", "--gif",
                to + ".gif", "--sheet", to + ".png", "--gif-scale", "4", "--jobs", jobs});
  };
  run("one", "1");
  run("three", "3");
  expect_equal_folders("one", "three");
  for (const char* file : {".wav", ".gif", ".png"})
    EXPECT_TRUE(read_file(folder / (std::string("one") + file)) ==
                read_file(folder / (std::string("three") + file)))
        << file;
}

TEST_F(CliJobsTest, SeveralProcessesCompareAndMapAsOne) {
  const std::vector<std::string> what = {"--every",  "4000",    "--frames",  "2",
                                         "--golden", "compare", "--overlay", "cost"};
  render("one", what);
  auto more = what;
  more.insert(more.end(), {"--jobs", "2"});
  render("two", more);
  expect_equal_folders("one", "two");
}

TEST_F(CliJobsTest, SeveralProcessesRenderRtlAndGoldenTracers) {
  for (const std::vector<std::string>& what :
       {std::vector<std::string>{"--use", "stacks=rtl", "--frames", "2"},
        std::vector<std::string>{"--golden", "trace4", "--frames", "9"}}) {
    render("one", what);
    auto more = what;
    more.insert(more.end(), {"--jobs", "2"});
    render("two", more);
    expect_equal_folders("one", "two");
    fs::remove_all(folder / "one");
    fs::remove_all(folder / "two");
  }
}

TEST_F(CliJobsTest, AnInterruptKeepsTheWholeFrames) {
  Program program(folder.path(),
                  {"render", "demo", "--frames", "3000", "-o", "out", "--jobs", "2"});
  for (int i = 0; i < 3000 && !fs::exists(folder / "out/frame_0009.png"); ++i) usleep(10000);
  program.signal(SIGINT);
  EXPECT_EQ(program.wait(), 130) << program.err();
  EXPECT_THAT(program.err(), HasSubstr("stopped early; kept "));
  const auto manifest = read_json(folder / "out/manifest.json");
  const int frames = manifest.at("frames_rendered").get<int>();
  EXPECT_GE(frames, 10);
  EXPECT_EQ(manifest.at("files").size(), static_cast<std::size_t>(frames) + 1);  // stats.json
  for (const auto& entry : fs::directory_iterator(folder / "out")) {
    if (entry.path().filename() == "manifest.json") continue;
    EXPECT_THAT(manifest.at("files").elements(),
                testing::Contains(entry.path().filename().string()));
  }
}

TEST_F(CliJobsTest, RefusesWhatNeedsOneProcess) {
  Program lockstep(folder.path(), {"render", "demo", "--use", "stacks=lockstep", "--jobs", "2"});
  EXPECT_EQ(lockstep.wait(), 2);
  EXPECT_THAT(lockstep.err(), HasSubstr("leave out --jobs, or use stacks=rtl"));
  Program many(folder.path(), {"render", "demo", "--jobs", "257"});
  EXPECT_EQ(many.wait(), 2);
  EXPECT_THAT(many.err(), HasSubstr("--jobs 257 is out of range; processes: 1..256"));
}

}  // namespace
}  // namespace racebeam
