// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <filesystem>

#include "tb/base/child.h"
#include "tb/base/output_file.h"
#include "tb/base/whole_file.h"
#include "tests/sweep/sweep_store.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

class SweepFolderTest : public testing::Test {
 protected:
  std::string refusal(Access access) const {
    return error_of([this, access] { SweepFolder sweep(path, access); });
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(path + "/" + name); }

  QuickFolder folder;
  const std::string path = folder / "out/stack";
};

/// A line that a child writes.
std::string line_from(int file) {
  std::string line;
  for (char c; read(file, &c, 1) == 1 && c != '\n';) line += c;
  return line;
}

/// Takes the folder, says "runs" or why not, and keeps it until `finish` ends.
[[noreturn]] void start(const std::string& path, int answer, int finish) {
  const auto say = [answer](const std::string& text) {
    if (write(answer, (text + "\n").data(), text.size() + 1) < 0) _exit(1);
  };
  try {
    const SweepFolder sweep(path, Access::Write);
    say("runs");
    line_from(finish);
  } catch (const std::exception& error) {
    say(error.what());
  }
  _exit(0);
}

TEST_F(SweepFolderTest, OfTwoStartsAtOnceOneRunsAndOneSaysSo) {
  for (int round = 0; round < 20; ++round) {
    int answers[2][2], finish[2];
    pid_t children[2];
    ASSERT_EQ(pipe(finish), 0);
    for (int i = 0; i < 2; ++i) {
      ASSERT_EQ(pipe(answers[i]), 0);
      children[i] = fork_child();
      if (children[i] != 0) continue;
      close(finish[1]);
      start(path, answers[i][1], finish[0]);
    }
    std::string said[2];
    for (int i = 0; i < 2; ++i) said[i] = line_from(answers[i][0]);
    const int loser = said[0] == "runs" ? 1 : 0;
    EXPECT_EQ(said[1 - loser], "runs");
    EXPECT_THAT(said[loser],
                MatchesRegex(path + " is in use by process " + std::to_string(children[1 - loser]) +
                             " on this machine since [0-9]*:[0-9]*; racebeam sweep status " + path +
                             " shows how far it is"));
    for (const int file :
         {finish[0], finish[1], answers[0][0], answers[0][1], answers[1][0], answers[1][1]})
      close(file);
    for (const pid_t child : children) wait_for_child(child);
  }
}

TEST_F(SweepFolderTest, LockDiesWithItsOwner) {
  int answer[2], never[2];
  ASSERT_EQ(pipe(answer), 0);
  ASSERT_EQ(pipe(never), 0);
  const pid_t child = fork_child();
  if (child == 0) start(path, answer[1], never[0]);
  EXPECT_EQ(line_from(answer[0]), "runs");
  OpenStore(path + "/sweep.sqlite");
  EXPECT_THAT(*SweepFolder(path, Access::Read).user(),
              HasSubstr("process " + std::to_string(child) + " on this machine since "));
  kill(child, SIGKILL);
  wait_for_child(child);
  EXPECT_FALSE(SweepFolder(path, Access::Read).user());
  EXPECT_EQ(refusal(Access::Write), "no error");
}

TEST_F(SweepFolderTest, WhatIsKeptIsThereForOthers) {
  SweepFolder sweep(path, Access::Write);
  EXPECT_EQ(sweep.sweep(), "");
  sweep.keep_sweep("name = \"a\"\n");
  sweep.keep_status("{\"done\": 1}");
  sweep.keep_status("{\"done\": 2}");
  EXPECT_EQ(sweep.keep_failure("no \"limits\"/1", "died"), "failed/no%20%22limits%22%2F1.txt");
  sweep.keep_picture("a.png", "x");
  EXPECT_TRUE(sweep.has_picture("a.png"));
  EXPECT_FALSE(sweep.has_picture("b.png"));
  OpenStore store(sweep.store());
  const SweepFolder other(path, Access::Read);
  EXPECT_EQ(other.sweep(), "name = \"a\"\n");
  EXPECT_EQ(other.status(), "{\"done\": 2}");
  EXPECT_EQ(whole_file(path + "/failed/no%20%22limits%22%2F1.txt"), "died");
}

TEST_F(SweepFolderTest, MovedFolderStillWorks) {
  {
    const SweepFolder sweep(path, Access::Write);
    sweep.keep_sweep("x");
    OpenStore store(sweep.store());
    store.frames.put(store.key, {measured(1, 1)});
  }
  std::filesystem::rename(path, folder / "moved");
  const SweepFolder sweep(folder / "moved", Access::Write);
  OpenStore store(sweep.store());
  EXPECT_EQ(store.frames.read(store.key).size(), 1u);
  EXPECT_EQ(sweep.sweep(), "x");
}

TEST_F(SweepFolderTest, FolderOfSomethingElseIsNamedAndLeftAlone) {
  EXPECT_EQ(refusal(Access::Read), path + " is not the folder of a sweep: it has no sweep.sqlite");
  std::filesystem::create_directories(path);
  write_text(path + "/thesis.tex", "x");
  EXPECT_EQ(refusal(Access::Write), path +
                                        " is not the folder of a sweep: it has thesis.tex, but "
                                        "no sweep.sqlite; name a new folder with -o");
  EXPECT_FALSE(exists("lock"));
}

TEST_F(SweepFolderTest, StartThatWasKilledBeforeItsStoreIsNotInTheWay) {
  { SweepFolder(path, Access::Write).keep_sweep("x"); }
  EXPECT_TRUE(exists("sweep.toml"));
  EXPECT_EQ(refusal(Access::Write), "no error");
}

TEST(SweepFolderNames, AreFilesWhateverTheyAre) {
  EXPECT_EQ(file_name_of("p31"), "p31");
  EXPECT_EQ(file_name_of("../x"), "%2E.%2Fx");
  EXPECT_EQ(file_name_of(""), "%");
  const std::string a(3000, 'a');
  EXPECT_LT(file_name_of(a).size(), 120u);
  EXPECT_NE(file_name_of(a), file_name_of(a + "b"));
}

}  // namespace
}  // namespace racebeam
