// One SIGTERM, sent to the program alone, ends every command with all its children, whatever they
// are doing; nobody outlives a program that is killed.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <filesystem>
#include <optional>

#include "tests/cli/faulty_rtl.h"
#include "tests/cli/racebeam_processes.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class CliInterruptTest : public testing::Test {
 protected:
  /// Starts the program in its folder.
  void start(const Words& arguments) {
    Program::Setting setting;
    setting.environment = own.mark();
    program.emplace(folder.path(), arguments, setting);
  }
  /// It has so many processes, itself too, and is at work.
  void expect_processes(int wanted) {
    ASSERT_TRUE(own.work_as(wanted)) << own.count() << " processes";
  }
  void expect_end_by(int signal, const std::string& what) {
    program->signal(signal);
    EXPECT_EQ(program->wait(), signal == SIGKILL ? -SIGKILL : 130) << what << program->err();
    EXPECT_TRUE(own.become(0)) << what << ": " << own.count() << " processes are left";
  }
  /// The RTL says a word, and then never returns.
  void write_endless() {
    std::ofstream(folder / "mine.sv")
        << faulty_stacks("$display(\"it begins\"); while (clocks_q == 500) $c(\"\");");
  }
  void expect_begun() {
    for (int n = 0; n < 6000 && program->said().find("it begins") == std::string::npos; ++n)
      usleep(10'000);
    ASSERT_THAT(program->said(), HasSubstr("it begins"));
  }

  ScratchFolder folder;
  MarkedProcesses own;
  std::optional<Program> program;
};

/// What verilates would be counted too.
void verilate_first() {
  const ScratchFolder other;
  Program run(other.path(), {"verify", "stacks", "--frames", "0", "--random", "1"});
  ASSERT_EQ(run.wait(), 0) << run.err();
}

const Words Endless = {"verify", "stacks", "--frames", "0", "--random", "99999999999"};

TEST_F(CliInterruptTest, TermEndsVerifyInRandomTraffic) {
  verilate_first();
  for (const int signal : {SIGTERM, SIGINT}) {
    start(Endless);
    expect_processes(2);
    expect_end_by(signal, "random traffic");
    EXPECT_THAT(program->out(), HasSubstr("stacks")) << "what was compared is told";
  }
}

TEST_F(CliInterruptTest, KilledProgramsLeaveNobody) {
  verilate_first();
  start(Endless);
  expect_processes(2);  // which shows that they are found
  expect_end_by(SIGKILL, "verify");
  start({"render", "demo", "--frames", "3000", "--jobs", "3"});
  expect_processes(4);
  expect_end_by(SIGKILL, "render");
  start({"trace", "demo", "--record", "2", "--from", "0:-273", "--to", "900:0", "-o", "t.vcd"});
  expect_processes(3);
  expect_end_by(SIGKILL, "trace");
}

TEST_F(CliInterruptTest, TermEndsRtlThatNeverReturns) {
  write_endless();
  for (const Words& words :
       {Words{"verify", "stacks=mine.sv", "--frames", "0"},
        Words{"verify", "stacks=mine.sv", "--random", "0"},
        Words{"render", "demo", "--use", "stacks=mine.sv", "--frames", "9"},
        Words{"render", "demo", "--use", "stacks=mine.sv", "--frames", "9", "--jobs", "2"},
        Words{"trace", "demo", "--use", "stacks=mine.sv", "--from", "0:0", "--to", "0:9", "-o",
              "t.vcd"},
        Words{"view", "demo", "--use", "stacks=mine.sv", "--term", "--frames", "9"}}) {
    start(words);
    expect_begun();
    expect_end_by(SIGTERM, words[0]);
  }
}

TEST_F(CliInterruptTest, TermEndsAPipeWithoutAReader) {
  ASSERT_EQ(mkfifo((folder / "a.gif").c_str(), 0600), 0);
  start({"render", "demo", "--frames", "2", "--gif", "a.gif", "-o", "out"});
  for (int n = 0; n < 6000 && !fs::exists(folder / "out"); ++n) usleep(10'000);
  usleep(300'000);
  expect_end_by(SIGTERM, "render");
}

// A frame at the signal level takes long: its end is not waited for.
TEST_F(CliInterruptTest, TermKeepsTheWholeFramesOfASlowChip) {
  start({"render", "demo", "--frames", "900", "--level", "signal", "-o", "out"});
  for (int n = 0; n < 12000 && !fs::exists(folder / "out/frame_0000.png"); ++n) usleep(10'000);
  expect_end_by(SIGTERM, "render");
  const auto manifest = read_json(folder / "out/manifest.json");
  EXPECT_GE(manifest["frames_rendered"], 1);
  EXPECT_EQ(manifest["complete"], false);
}

TEST_F(CliInterruptTest, AKilledWorkerIsToldAndTheManifestKept) {
  start({"render", "demo", "--frames", "3000", "--jobs", "2", "-o", "out"});
  for (int n = 0; n < 6000 && !fs::exists(folder / "out/frame_0000.png"); ++n) usleep(10'000);
  const std::vector<int> children = program->children_ids();
  ASSERT_EQ(children.size(), 2u);
  kill(children[0], SIGKILL);
  EXPECT_EQ(program->wait(), 3);
  EXPECT_THAT(program->err(), HasSubstr("a process that rendered frames died: Killed"));
  EXPECT_THAT(program->err(), HasSubstr("stopped early; kept "));
  EXPECT_TRUE(fs::exists(folder / "out/manifest.json"));
  EXPECT_TRUE(own.become(0));
}

}  // namespace
}  // namespace racebeam
