// Promises of `racebeam shake` and of --shake: what they refuse, and that model and RTL are stalled
// alike.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

class CliShakeTest : public testing::Test {
 protected:
  void expect_refused(const Words& words, const std::string& said) {
    Program run(folder.path(), words);
    EXPECT_EQ(run.wait(), 2) << run.err();
    EXPECT_THAT(run.err(), HasSubstr(said));
    EXPECT_EQ(run.out(), "");
    EXPECT_EQ(folder.files(), 0);
  }
  ScratchFolder folder;
};

TEST_F(CliShakeTest, AChannelThatIsNotThereOrMayNotStallIsRefusedWithTheList) {
  const std::string may = "interval, decision, camera";
  expect_refused({"shake", "demo", "--stall", "intervall"},
                 "unknown channel 'intervall'; did you mean 'interval'? (there is: " + may);
  expect_refused({"shake", "demo", "--stall", "push"},
                 "channel push of beam may not stall: no answer: written in this clock; these "
                 "may: " +
                     may);
  expect_refused({"verify", "stacks", "--shake", "1", "--stall", "beam"}, "these may: " + may);
  expect_refused({"render", "demo", "--stall", "interval"}, "add --shake");
}

TEST_F(CliShakeTest, ASeedOrAShareOutOfRangeIsRefused) {
  expect_refused({"shake", "demo", "--shake", "x"}, "the seed 'x' is not a whole number");
  expect_refused({"shake", "demo", "--shake", "1.5"}, "the seed '1.5' is not a whole number");
  expect_refused({"shake", "demo", "--shake", "4294967296"}, "out of range; 0..4294967295");
  expect_refused({"shake", "demo", "--shake", "1,2,0.5"}, "BEGIN 2 is out of range; 0..1");
  expect_refused({"shake", "demo", "--shake", "1,-0.1,0.5"}, "BEGIN -0.1 is out of range; 0..1");
  expect_refused({"shake", "demo", "--shake", "1,0.1,1"}, "GO_ON 1 is out of range; 0..0.99");
  expect_refused({"shake", "demo", "--shake", "1,nan,0.5"}, "BEGIN nan is out of range");
  expect_refused({"shake", "demo", "--shake", "1,0.1"}, "has 2 numbers");
  expect_refused({"shake", "demo", "--shake", "1,a,b"}, "'a' is not a number");
  expect_refused({"shake", "demo", "--seeds", "0"}, "--seeds 0 is out of range");
  expect_refused({"shake", "demo", "--frames", "12800"}, "--frames 12800 is out of range");
}

TEST_F(CliShakeTest, WhatHasNoWiresCannotStall) {
  expect_refused({"render", "demo", "--shake", "1", "--level", "tlm"}, "leave out --level tlm");
  expect_refused({"render", "demo", "--shake", "1", "--golden", "trace4"}, "leave out --golden");
  expect_refused({"verify", "racebeam_top", "--shake", "1"}, "racebeam_top has wires of its own");
  expect_refused({"verify", "stacks", "--shake", "1", "--frames", "0"}, "leave out --frames 0");
}

TEST_F(CliShakeTest, ChannelsAreListedWithWhatMakesStallsHarmless) {
  Program run(folder.path(), {"shake", "--channels", "--engine", "sphere", "--json"});
  ASSERT_EQ(run.wait(), 0) << run.err();
  const Json all = run.json();
  int may = 0;
  for (const auto& channel : all["channels"].elements()) {
    EXPECT_FALSE(channel["why"].get<std::string>().empty());
    may += channel["may_stall"].get<bool>();
  }
  EXPECT_EQ(may, 4);
}

TEST_F(CliShakeTest, ModelAndRtlAreStalledAlike) {
  Program run(folder.path(), {"verify", "subdivider", "interval_fifo", "camera_unit", "--frames",
                              "1", "--random", "0", "--shake", "7,0.1,0.8", "--json"});
  ASSERT_EQ(run.wait(), 0) << run.err();
  const Json all = run.json();
  ASSERT_EQ(all["units"].size(), 3u);
  for (const auto& unit : all["units"].elements()) EXPECT_EQ(unit["differences"], 0);
}

TEST_F(CliShakeTest, StallsMoveTimeAndAreTheSameInEachRender) {
  const Words words = {"render", "demo", "--first", "7223", "--shake", "7", "--crc", "--json"};
  Words quiet = words;
  quiet.erase(quiet.begin() + 4, quiet.begin() + 6);
  quiet.insert(quiet.end(), {"--level", "signal"});
  const ScratchFolder other_folder, quiet_folder;
  Program first(folder.path(), words), again(other_folder.path(), words),
      other(quiet_folder.path(), quiet);
  ASSERT_EQ(first.wait(), 0) << first.err();
  ASSERT_EQ(again.wait(), 0) << again.err();
  ASSERT_EQ(other.wait(), 0) << other.err();
  EXPECT_EQ(first.out(), again.out());
  EXPECT_NE(first.out(), other.out());
}

}  // namespace
}  // namespace racebeam
