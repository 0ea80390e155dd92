// Promises of `racebeam delays` and of --delays: what they refuse, and what they foretell.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

class CliDelaysTest : public testing::Test {
 protected:
  std::string fresh(const Words& more = {}) {
    Words words{"delays", "new"};
    words.insert(words.end(), more.begin(), more.end());
    Program run(folder.path(), words);
    EXPECT_EQ(run.wait(), 0) << run.err();
    return run.out();
  }
  /// The template with one change.
  void write(const std::string& what, const std::string& instead) {
    std::string text = fresh();
    const auto at = text.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    std::ofstream(folder / "d.toml") << text.replace(at, what.size(), instead);
  }
  void expect_refused(const Words& words, const Words& said) {
    Program run(folder.path(), words);
    EXPECT_EQ(run.wait(), 2) << run.err();
    for (const std::string& one : said) EXPECT_THAT(run.err(), HasSubstr(one));
    EXPECT_EQ(run.out(), "");
  }
  void expect_file_refused(const std::string& what, const std::string& instead, const Words& said) {
    write(what, instead);
    expect_refused({"render", "demo", "--delays", "d.toml"}, said);
  }
  ScratchFolder folder;
};

TEST_F(CliDelaysTest, AChannelThatIsNotThereOrMayNotBeDelayedIsRefusedWithTheList) {
  const std::string may = "interval, line";
  expect_file_refused("name = \"interval\"", "name = \"intervall\"",
                      {"1 fault in d.toml", "d.toml:", "unknown channel 'intervall'", may});
  expect_file_refused("name = \"interval\"", "name = \"decision\"",
                      {"channel decision of beam may not be delayed: subdivider moves in the clock",
                       "these may: " + may});
  expect_refused({"delays", "run", "demo", "--channel", "push"},
                 {"channel push of beam may not be delayed: no answer", "these may: " + may});
}

TEST_F(CliDelaysTest, ALatencyBeyondItsRegistersIsRefused) {
  expect_file_refused(
      "latency = 0", "latency = 3",
      {"latency 3 of channel interval is beyond what its registers hold: capacity 2",
       "capacity = 3 holds one a clock, 4 lets an offer in every clock through"});
  expect_file_refused("latency = 0", "latency = 64", {"latency", "0..63"});
  expect_file_refused("capacity = 2", "capacity = 0", {"capacity", "1..256"});
  expect_file_refused("latency = 0\n", "", {"latency"});
}

TEST_F(CliDelaysTest, AFileOfOtherUnitsOrAnotherEngineIsRefused) {
  expect_file_refused("to = \"interval_fifo\"", "to = \"stacks\"",
                      {"channel interval is to interval_fifo, not 'stacks'"});
  expect_file_refused("engine = \"beam\"", "engine = \"voxel\"",
                      {"these are channels of 'voxel', and the chip is beam"});
  expect_file_refused("name = \"line\"\nfrom = \"vga_timing\"\nto = \"camera_unit\"",
                      "name = \"interval\"\nfrom = \"subdivider\"\nto = \"interval_fifo\"",
                      {"channel interval is there twice"});
  expect_file_refused("latency = 0", "depth = 0", {"depth"});
  expect_refused({"render", "demo", "--delays", "none.toml"}, {"none.toml"});
}

TEST_F(CliDelaysTest, WhatHasNoWiresCannotBeDelayed) {
  write("latency = 0", "latency = 1");
  const Words file{"--delays", "d.toml"};
  expect_refused({"render", "demo", "--delays", "d.toml", "--level", "tlm"},
                 {"leave out --level tlm"});
  expect_refused({"render", "demo", "--delays", "d.toml", "--golden", "trace4"},
                 {"leave out --golden"});
  expect_refused({"render", "demo", "--delays", "d.toml", "--shake", "1"},
                 {"leave out one of them"});
  expect_refused({"verify", "racebeam_top", "--delays", "d.toml"}, {"name a file that has them"});
  expect_refused({"verify", "stacks", "--delays", "d.toml", "--frames", "0"},
                 {"leave out --frames 0"});
}

TEST_F(CliDelaysTest, TheTemplateOfEachEngineIsReadAndDelaysNothing) {
  for (const std::string engine : {"beam", "sphere", "block", "voxel"}) {
    const std::string text = fresh({"--engine", engine});
    EXPECT_THAT(text, HasSubstr("engine = \"" + engine + "\""));
    EXPECT_THAT(text, HasSubstr("latency = 0"));
  }
  write("latency = 0", "latency = 0");
  Program with(folder.path(), {"render", "demo", "--delays", "d.toml", "--at", "7223", "--json"});
  ASSERT_EQ(with.wait(), 0) << with.err();
  Program without(folder.path(), {"render", "demo", "--level", "signal", "--at", "7223", "--json"});
  ASSERT_EQ(without.wait(), 0) << without.err();
  EXPECT_EQ(with.out(), without.out());
}

TEST_F(CliDelaysTest, AFileThatIsThereStays) {
  std::ofstream(folder / "d.toml") << "mine";
  expect_refused({"delays", "new", "-o", "d.toml"}, {"d.toml exists"});
  std::ifstream left(folder / "d.toml");
  std::string word;
  left >> word;
  EXPECT_EQ(word, "mine");
}

TEST_F(CliDelaysTest, SlackEndsWhereMorePixelsStarve) {
  Program run(folder.path(), {"delays", "run", "demo", "--at", "7223", "--max", "2", "--json"});
  ASSERT_EQ(run.wait(), 0) << run.err();
  for (const auto& channel : run.json()["channels"].elements()) {
    const auto rows = channel["by_latency"].elements();
    ASSERT_EQ(rows.size(), 3u);
    const auto starved = [&](std::size_t n) { return rows[n]["starved_pixels"].get<int>(); };
    const int slack = channel["starving_slack"].get<int>();
    for (std::size_t n = 1; n <= static_cast<std::size_t>(slack); ++n)
      EXPECT_LE(starved(n), starved(0));
    if (slack < 2) {
      EXPECT_GT(starved(static_cast<std::size_t>(slack) + 1), starved(0));
    }
    EXPECT_EQ(rows[0]["other_pixels"].get<int>(), 0);
  }
}

}  // namespace
}  // namespace racebeam
