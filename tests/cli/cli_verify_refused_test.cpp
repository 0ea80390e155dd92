// What `racebeam verify` refuses before it compares anything.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;

class CliVerifyRefusedTest : public testing::Test {
 protected:
  void expect_refused(const std::vector<std::string>& more, const std::string& said,
                      const Program::Setting& setting = {}) {
    std::vector<std::string> words = {"verify", "stacks"};
    words.insert(words.end(), more.begin(), more.end());
    Program run(folder.path(), words, setting);
    EXPECT_EQ(run.wait(), 2) << run.err();
    EXPECT_THAT(run.err(), HasSubstr(said));
    EXPECT_THAT(run.err(), Not(HasSubstr("internal error")));
    EXPECT_EQ(run.out(), "") << "it has compared something";
    EXPECT_EQ(folder.files(), 0) << "it has left something";
  }

  ScratchFolder folder;
};

TEST_F(CliVerifyRefusedTest, AFolderForWaveformsThatCannotBeMadeIsNamedAtOnce) {
  expect_refused({"-o", "/proc/x"}, "cannot write /proc/x: No such file or directory");
  expect_refused({"-o", "/proc/x/y"}, "cannot write /proc/x/y: ");
  expect_refused({"-o", "/dev/null"}, "cannot write /dev/null: Not a directory");
  expect_refused({"-o", "/dev/null", "--watch"}, "cannot write /dev/null: ");
}

TEST_F(CliVerifyRefusedTest, ARunThatComparesNothingIsNoSuccess) {
  expect_refused({"--frames", "0", "--random", "0"},
                 "--frames 0 and --random 0 compare nothing; leave out one of them");
  expect_refused({"--frames", "0", "--random", "0", "--watch"}, "compare nothing");
}

TEST_F(CliVerifyRefusedTest, TheModelIsNotComparedWithItself) {
  expect_refused({"navigator=model"}, "navigator=model: nothing is beside the model");
  expect_refused({"all=model"}, "all=model: nothing is beside the model; write all for its RTL");
}

TEST_F(CliVerifyRefusedTest, WatchDoesNotWaitForWhatNoSavingMends) {
  expect_refused({"--watch", "--set", "nosuch=1"}, "unknown knob 'nosuch'");
  expect_refused({"--watch", "--set", "fifo_entries=0"}, "fifo_entries");
  expect_refused({"--watch", "--scene", "none.toml"}, "none.toml");
  expect_refused({"--watch", "--frames", "12800"}, "--frames 12800 is out of range");
}

TEST_F(CliVerifyRefusedTest, APatienceThatIsNoNumberOfSecondsIsNamed) {
  for (const std::string wish : {"abc", "1s", "0", "-1", "nan"}) {
    Program::Setting setting;
    setting.environment = "RACEBEAM_RTL_SECONDS=" + wish;
    expect_refused({"--frames", "0", "--random", "10"},
                   "RACEBEAM_RTL_SECONDS is '" + wish + "'; write a number of seconds from 0.1 on",
                   setting);
  }
}

}  // namespace
}  // namespace racebeam
