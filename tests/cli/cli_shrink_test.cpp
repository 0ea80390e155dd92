// `racebeam verify` leaves a difference on random traffic as a stream of few clocks, which plays
// again.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>

#include "tb/base/project_folder.h"
#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

class CliShrinkTest : public testing::Test {
 protected:
  /// mine.sv: the RTL of a unit with one place changed.
  void write_mine(const std::string& unit, const std::string& right, const std::string& wrong) {
    std::string text = read_file(rtl_file(unit));
    const auto at = text.find(right);
    ASSERT_NE(at, std::string::npos) << right;
    std::ofstream(folder / "mine.sv") << text.replace(at, right.size(), wrong);
  }
  /// The ring of stacks is read at the wrong end.
  void write_faulty_stacks() {
    write_mine("stacks", "(n + 1) % IntervalStackDepth", "n % IntervalStackDepth");
  }
  int run(const Words& words) {
    Program program(folder.path(), words);
    const int code = program.wait();
    said = program.err();
    out = program.out();
    return code;
  }
  Json first() const { return Json::parse(out)["units"][0]["first"]; }

  const Words random = {"verify", "stacks=mine.sv", "--frames", "0", "--random", "20000"};
  const std::string stream = "racebeam_verify/stacks_random.stream";
  const Words play = {"verify", "stacks=mine.sv", "--stream", stream, "--json"};
  ScratchFolder folder;
  std::string said, out;
};

TEST_F(CliShrinkTest, AStreamOfFewClocksFailsAgainAtTheSamePortWithTheSameValues) {
  write_faulty_stacks();
  Words words = random;
  words.push_back("--json");
  ASSERT_EQ(run(words), 1) << said;
  const auto found = first();
  const auto shrunk = found["shrunk"];
  EXPECT_LE(shrunk["clocks"].get<int>(), 10);
  EXPECT_LE(shrunk["moving"].get<int>(), 3);
  EXPECT_EQ(shrunk["stream"], stream);
  EXPECT_THAT(shrunk["repeat"].get<std::string>(),
              testing::AllOf(HasSubstr("verify stacks=mine.sv"), HasSubstr("--stream " + stream)));
  ASSERT_EQ(run(play), 1) << said;
  const auto again = first();
  EXPECT_EQ(again["port"], found["port"]);
  EXPECT_EQ(again["clock"], shrunk["clocks"]);
  EXPECT_EQ(again["expected"], shrunk["expected"]);
  EXPECT_EQ(again["got"], shrunk["got"]);
  EXPECT_EQ(Json::parse(out)["units"][0]["traffic"], "stream");
  EXPECT_THAT(again["text"].get<std::string>(), HasSubstr("differs on the stream " + stream));
}

TEST_F(CliShrinkTest, TheTableHasOnlyWhatMovesAndTheFileIsTheSameEachTime) {
  write_faulty_stacks();
  ASSERT_EQ(run(random), 1);
  const std::string file = read_file(folder / stream);
  const std::string text = said.substr(said.find("\nshrunk to "));
  EXPECT_THAT(text, testing::ContainsRegex("^\nshrunk to [0-9]+ clocks? after the reset, [0-9] of "
                                           "[0-9]+ inputs moving; the model has "));
  EXPECT_THAT(text, testing::ContainsRegex("top_[a-z0-9_]+ rtl [^\n]*>[0-9a-f]+"));
  EXPECT_THAT(text, HasSubstr("\nheld: "));
  EXPECT_THAT(text, Not(HasSubstr(" both ")));
  EXPECT_THAT(text, HasSubstr("\nrepeat: racebeam verify stacks=mine.sv --scene demo --stream "));
  ASSERT_EQ(run(random), 1);
  EXPECT_EQ(read_file(folder / stream), file);
}

TEST_F(CliShrinkTest, TheRegisterThatDiffersFirstIsToldWithBothSides) {
  write_mine("interval_fifo", "head_len_q <= head_len_d;", "head_len_q <= head_len_d ^ 10'd4;");
  ASSERT_EQ(run({"verify", "interval_fifo=mine.sv", "--frames", "0", "--random", "20000"}), 1);
  const std::string text = said.substr(said.find("\nshrunk to "));
  EXPECT_THAT(text, testing::ContainsRegex("\n  head_len_q model +[0-9a-f]"));
  EXPECT_THAT(text, testing::ContainsRegex("\n  head_len_q rtl +[^\n]*>[0-9a-f]"));
  EXPECT_THAT(text,
              testing::ContainsRegex("\nregisters: head_len_q differs? first, in clock -?[0-9]+"
                                     "; [0-9]+ of the 13 registers named alike do"));
  ASSERT_EQ(run({"verify", "interval_fifo=mine.sv", "--stream",
                 "racebeam_verify/interval_fifo_random.stream"}),
            1);
  EXPECT_THAT(said, testing::ContainsRegex("\n  head_len_q rtl +[^\n]*>[0-9a-f]"));
}

TEST_F(CliShrinkTest, RegistersThatAgreePointToWhatIsComputedFromThem) {
  write_faulty_stacks();
  ASSERT_EQ(run(random), 1);
  EXPECT_THAT(
      said, testing::ContainsRegex("\nregisters: no difference up to here in the [0-9]+ "
                                   "registers named alike: look at what is computed from them\n"));
}

TEST_F(CliShrinkTest, TheUnitsOwnRtlDoesWhatTheModelDoesOnTheStream) {
  write_faulty_stacks();
  ASSERT_EQ(run(random), 1);
  EXPECT_EQ(run({"verify", "stacks", "--stream", stream}), 0) << said;
}

TEST_F(CliShrinkTest, AnEditedNumberOfTheFileIsPlayed) {
  write_mine("interval_fifo", "assign display_o = display[1:0];",
             "assign display_o = value_i == 3 ? ~display[1:0] : display[1:0];");
  std::ofstream(folder / "a.stream")
      << "# racebeam-stream 1\nunit interval_fifo\nclock value_i\n1..5 0\n6 3\n7 0\n";
  const auto verify = [&] {
    return run({"verify", "interval_fifo=mine.sv", "--stream", "a.stream", "--json"});
  };
  ASSERT_EQ(verify(), 1) << said;
  EXPECT_EQ(first()["clock"], 6);
  std::ofstream(folder / "a.stream")
      << "# racebeam-stream 1\nunit interval_fifo\nclock value_i\n1..5 0\n6 2\n7 0\n";
  EXPECT_EQ(verify(), 0) << said;
}

TEST_F(CliShrinkTest, WithoutShrinkingTheDifferenceStaysAsItWasFound) {
  write_faulty_stacks();
  Words words = random;
  words.insert(words.end(), {"--json", "--no-shrink"});
  ASSERT_EQ(run(words), 1);
  EXPECT_FALSE(first().contains("shrunk"));
  EXPECT_THAT(first()["text"].get<std::string>(), Not(HasSubstr("shrunk")));
  EXPECT_FALSE(std::filesystem::exists(folder / stream));
}

// The frame that a counter of frames was put to is part of a stream.
TEST_F(CliShrinkTest, AFrameOfTheDemoIsPlayedAgain) {
  write_mine("sequencer", "palette_o = scene_palette;",
             "palette_o = frame_q == 12798 ? ~scene_palette : scene_palette;");
  ASSERT_EQ(run({"verify", "sequencer=mine.sv", "--frames", "0", "--json"}), 1) << said;
  const auto shrunk = first()["shrunk"];
  EXPECT_LE(shrunk["clocks"].get<int>(), 2);
  EXPECT_THAT(read_file(folder / "racebeam_verify/sequencer_random.stream"),
              HasSubstr("\nframe 12798\n"));
  EXPECT_EQ(
      run({"verify", "sequencer=mine.sv", "--stream", "racebeam_verify/sequencer_random.stream"}),
      1);
}

TEST_F(CliShrinkTest, WhatCannotBePlayedIsRefused) {
  const auto refused = [&](const Words& more) {
    Words words = {"verify"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(run(words), 2);
    EXPECT_EQ(out, "");
    return said;
  };
  std::ofstream(folder / "a.stream") << "# racebeam-stream 1\nunit stacks\nclock nope_i\n1 0\n";
  EXPECT_THAT(refused({"stacks", "--stream", "a.stream"}),
              HasSubstr("a.stream:3: unknown input of stacks 'nope_i'"));
  for (const Words& units : {Words{}, Words{"camera_unit"}, Words{"stacks", "scene"}}) {
    Words words = units;
    words.insert(words.end(), {"--stream", "a.stream"});
    EXPECT_THAT(refused(words), HasSubstr("a.stream is a stream for stacks; name that unit"));
  }
  EXPECT_THAT(refused({"stacks", "--stream", "none"}), HasSubstr("there is no file none"));
  EXPECT_THAT(refused({"stacks", "--stream", "a.stream", "--random", "5"}), HasSubstr("--random"));
  EXPECT_THAT(refused({"stacks", "--stream", "a.stream", "--frames", "5"}), HasSubstr("--frames"));
}

}  // namespace
}  // namespace racebeam
