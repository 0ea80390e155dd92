// `racebeam trace` through the command line: what it does not do, and says.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

class CliTraceRefusedTest : public testing::Test {
 protected:
  void expect_refused(const std::vector<std::string>& more, const std::string& words,
                      int code = 2) {
    std::vector<std::string> arguments = {"trace"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Program run(folder.path(), arguments);
    EXPECT_EQ(run.wait(), code);
    EXPECT_THAT(run.err(), HasSubstr(words));
  }

  ScratchFolder folder;
};

TEST_F(CliTraceRefusedTest, RefusesWindowsThatAreNone) {
  const auto window = [&](const char* from, const char* to, const std::string& words) {
    expect_refused({"demo", "-o", "t.vcd", "--from", from, "--to", to}, words);
  };
  window("60", "60:1", "--from '60' is not of the form FRAME:LINE or FRAME:LINE:CLOCK");
  window("60:1:2:3", "60:1", "is not of the form");
  window("60:x", "60:1", "is not of the form");
  window("12799:0", "60:1", "--from 12799:0: frame 12799 is out of range; 0..12798");
  window("60:-274", "60:1", "line -274 is out of range; -273..251");
  window("60:0:1600", "60:1", "clock 1600 is out of range; 0..1599");
  window("60:1", "60:0", "--to 60:0 comes before --from 60:1");
  const auto alone = [&](const char* option, const char* at, const std::string& words,
                         std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"demo", "-o", "t.vcd", option, at});
    expect_refused(more, words);
  };
  alone("--from", "0:300", "--from 0:300: line 300 is out of range; -273..251");
  alone("--to", "0:300", "--to 0:300: line 300 is out of range; -273..251");
  alone("--from", "12799:0", "--from 12799:0: frame 12799 is out of range; 0..12798");
  alone("--to", "1:2:1600", "--to 1:2:1600: clock 1600 is out of range; 0..1599");
  alone("--from", "x", "--from 'x' is not of the form");
  alone("--from", "0:300", "--from 0:300: line 300", {"--around", "max-stack"});
  alone("--to", "0:300", "--to 0:300: line 300", {"--when", "line == 1"});
  alone("--from", "0:300", "--from 0:300: line 300", {"--record", "3"});
  alone("--from", "0:30", "the window is missing: say --from FRAME:LINE and --to FRAME:LINE");
  expect_refused({"demo", "-o", "t.vcd"}, "--from FRAME:LINE");
  expect_refused({"demo", "-o", "t.vcd", "--around", "first-stravd"},
                 "did you mean 'first-starved'?");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST_F(CliTraceRefusedTest, RefusesWhatItCannotWrite) {
  const std::vector<std::string> window = {"--from", "0:0:0", "--to", "0:0:1"};
  const auto refused = [&](std::vector<std::string> more, const std::string& words) {
    more.insert(more.end(), window.begin(), window.end());
    expect_refused(more, words);
  };
  refused({"demo"}, "-o FILE.vcd");
  refused({"-o", "t.vcd"}, "scene is required");
  refused({"demo", "-o", "t.png"}, "ends with .vcd or .fst");
  refused({"demo", "-o", "t.vcd", "--scope", "chip.u_nothing"}, "no signal is under");
  refused({"demo", "-o", "none/t.vcd"},
          "cannot write none/t.vcd: No such file or directory\n"
          "racebeam: choose another place, or free some space\n");
  refused({"demo", "-o", "t.vcd", "--lines", "2"}, "--lines are lines around");
  expect_refused({"demo", "-o", "t.vcd", "--around", "max-stack", "--lines", "2", "--pre", "3"},
                 "are two windows");
  expect_refused({"demo", "-o", "t.vcd", "--record", "2", "--lines", "3"}, "leave out --pre and");
  refused({"demo", "-o", "t.vcd", "--depth", "-1"}, "--depth -1 is out of range");
  refused({"demo", "-o", "t.vcd", "--use", "stakcs=rtl"}, "did you mean 'stacks'?");
  expect_refused({"--diff", "a.vcd", "b.vcd"}, "cannot read a.vcd");
  std::ofstream(folder / "a.vcd") << "no waveform";
  expect_refused({"--diff", "a.vcd", "a.vcd"}, "is no value change dump");
}

TEST_F(CliTraceRefusedTest, NamesThePackageThatMakesFst) {
  Program::Setting bare;
  bare.environment = "PATH=/nowhere";
  Program run(folder.path(), {"trace", "demo", "-o", "t.fst", "--from", "0:0", "--to", "0:1"},
              bare);
  EXPECT_EQ(run.wait(), 3);
  EXPECT_THAT(run.err(), HasSubstr("install the package `gtkwave`"));
}

}  // namespace
}  // namespace racebeam
