// The command line: what is understood, what is refused and how.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sc/knobs.h"
#include "tests/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Words = std::vector<std::string>;

class CliTest : public testing::Test {
 protected:
  ScratchFolder folder;

  /// Exit code 2, a message with all of `parts`, no result, no file.
  void expect_refused(const Words& words, const std::vector<std::string>& parts) {
    Program program(folder.path(), words);
    EXPECT_EQ(program.wait(), 2) << testing::PrintToString(words);
    EXPECT_EQ(program.out(), "");
    EXPECT_THAT(program.err(), StartsWith("racebeam: "));
    for (const std::string& part : parts) EXPECT_THAT(program.err(), HasSubstr(part));
    EXPECT_EQ(folder.files(), 0);
  }
};

TEST_F(CliTest, HelpNamesEveryCommandAndIsGood) {
  Program program(folder.path(), {"--help"});
  EXPECT_EQ(program.wait(), 0);
  for (const char* command : {"render", "scene", "knobs", "bench", "doctor"})
    EXPECT_THAT(program.out(), HasSubstr(command));
  EXPECT_EQ(program.err(), "");
}

TEST_F(CliTest, HelpOfRenderNamesEveryOption) {
  Program program(folder.path(), {"render", "--help"});
  EXPECT_EQ(program.wait(), 0);
  for (const char* option :
       {"--frames", "--first", "--every", "--level", "--set", "--output", "--gif", "--wav",
        "--sheet", "--stats", "--crc", "--json", "--tt", "--ui"})
    EXPECT_THAT(program.out(), HasSubstr(option));
}

TEST_F(CliTest, VersionIsAlone) {
  Program program(folder.path(), {"--version"});
  EXPECT_EQ(program.wait(), 0);
  EXPECT_EQ(program.out(), "racebeam " RACEBEAM_VERSION "\n");
  EXPECT_EQ(program.err(), "") << "not even SystemC's banner";
}

TEST_F(CliTest, UnknownNamesAreRefusedWithTheNearest) {
  expect_refused({}, {"command is missing", "--help"});
  expect_refused({"rendr", "demo"}, {"unknown command 'rendr'", "did you mean 'render'?"});
  expect_refused({"--frobnicate"}, {"unknown option '--frobnicate'"});
  expect_refused({"knobs", "--jsn"}, {"unknown option '--jsn'", "'--json'"});
  expect_refused({"render"}, {"scene is required", "racebeam render --help"});
  expect_refused({"render", "dmo"}, {"unknown scene 'dmo'", "'demo'"});
  expect_refused({"render", "demo", "more"}, {"'more' is one argument too many"});
  expect_refused({"render", "demo", "--fraems", "3"}, {"unknown option '--fraems'", "'--frames'"});
  expect_refused({"render", "demo", "--fraems=3"}, {"unknown option '--fraems'", "'--frames'"});
  expect_refused({"render", "demo", "--level", "signl"}, {"unknown level 'signl'", "'signal'"});
  expect_refused({"render", "demo", "--level", "tml"}, {"unknown level 'tml'", "'tlm'"});
}

TEST_F(CliTest, NumbersOutOfRangeAreRefusedWithTheRange) {
  expect_refused({"render", "demo", "--frames", "0"}, {"--frames 0", "1..12799"});
  expect_refused({"render", "demo", "--frames", "12800"}, {"--frames 12800", "1..12799"});
  expect_refused({"render", "demo", "--frames", "many"}, {"--frames", "many"});
  expect_refused({"render", "demo", "--frames"}, {"--frames"});
  expect_refused({"render", "demo", "--first", "12799"}, {"--first 12799", "0..12798"});
  expect_refused({"render", "demo", "--first", "-1"}, {"--first -1", "0..12798"});
  expect_refused({"render", "demo", "--first", "99999999999999999999"}, {"--first", "0..12798"});
  expect_refused({"render", "demo", "--every", "0"}, {"--every 0", "1..12798"});
  expect_refused({"render", "demo", "--gif-scale", "9"}, {"--gif-scale 9", "1..8"});
}

TEST_F(CliTest, KnobsOutOfRangeAreRefusedWithTheRange) {
  const auto set = [](const char* assignment) {
    return Words{"render", "demo", "--set", assignment};
  };
  expect_refused(set("fifo_entris=4"), {"unknown knob 'fifo_entris'", "'fifo_entries'"});
  expect_refused(set("fifo_entries=65"), {"fifo_entries", "'65'", "3..64 entries"});
  expect_refused(set("fifo_entries=2"), {"'2'", "3..64"});
  expect_refused(set("fifo_entries=4x"), {"'4x'", "3..64"});
  expect_refused(set("fifo_entries="), {"''", "3..64"});
  expect_refused(set("bisection=middle"), {"'middle'", "pow2, midpoint"});
  expect_refused(set("interlace"), {"'interlace'", "knob=value"});
}

TEST_F(CliTest, SoundNeedsConsecutiveFramesAtTheChipsClock) {
  expect_refused({"render", "demo", "--wav", "a.wav", "--every", "2"}, {"--wav", "--every"});
  expect_refused({"render", "demo", "--wav", "a.wav", "--set", "clocks_per_pixel=4"},
                 {"--wav", "clocks_per_pixel=2"});
}

TEST_F(CliTest, OutputsThatCannotBeAreRefusedBeforeSimulating) {
  expect_refused({"render", "demo", "--sheet", "a.png", "--frames", "121"}, {"--sheet", "120"});
  expect_refused({"render", "demo", "--gif", "a", "--wav", "./a"}, {"a", "two outputs"});
  expect_refused({"render", "demo", "--gif", ""}, {"--gif", "empty"});
  expect_refused({"render", "demo", "-o", ""}, {"--output", "empty"});
  expect_refused({"render", "demo", "--gif", "no/a.gif"}, {"no/a.gif", "No such file"});
  expect_refused({"render", "demo", "-o", "new", "--wav", "no/a.wav"}, {"no/a.wav"});
  expect_refused({"render", "demo", "--stats", "."}, {"cannot write .", "directory"});
  expect_refused({"render", "demo", "-o", "/proc/racebeam"}, {"cannot write /proc/racebeam"});
  expect_refused({"render", "demo", "-o", RACEBEAM_BINARY "/out"}, {"Not a directory"});
}

TEST_F(CliTest, KnobsListsTheWholeTable) {
  Program table(folder.path(), {"knobs"});
  EXPECT_EQ(table.wait(), 0);
  Program json(folder.path(), {"knobs", "--json"});
  EXPECT_EQ(json.wait(), 0);
  const auto rows = json.json().at("knobs");
  ASSERT_EQ(rows.size(), knob_table().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const knob_info& row = knob_table()[i];
    for (const std::string& text : {std::string(row.name), row.range(), std::string(row.meaning)})
      EXPECT_THAT(table.out(), HasSubstr(text));
    EXPECT_EQ(rows[i].at("name"), row.name);
    EXPECT_EQ(rows[i].count("values"), row.names.empty() ? 0 : 1);
  }
  EXPECT_EQ(rows[0].at("default"), 4);
  EXPECT_EQ(rows[0].at("min"), 1);
  EXPECT_EQ(rows[0].at("max"), 64);
}

TEST_F(CliTest, DoctorIsGoodHere) {
  Program text(folder.path(), {"doctor"});
  EXPECT_EQ(text.wait(), 0) << text.out() << text.err();
  EXPECT_THAT(text.out(), HasSubstr("SystemC            2.3"));
  EXPECT_THAT(text.out(), Not(HasSubstr("FAILED")));
  Program program(folder.path(), {"doctor", "--json"});
  const auto json = program.json();
  EXPECT_EQ(json.at("versions").at("racebeam"), RACEBEAM_VERSION);
  EXPECT_EQ(json.at("checks").size(), 5);
  EXPECT_EQ(json.at("tools").size(), 4);
}

TEST_F(CliTest, DoctorEndsWith3WhenSomethingRequiredIsMissing) {
  Program program(folder.path(), {"doctor"}, {{}, RLIM_INFINITY, false, "TMPDIR=/no/such/folder"});
  EXPECT_EQ(program.wait(), 3);
  EXPECT_THAT(program.out(), HasSubstr("FAILED"));
  EXPECT_THAT(program.err(), HasSubstr("temporary folder"));
}

TEST_F(CliTest, DoctorNamesThePackageOfAMissingTool) {
  Program program(folder.path(), {"doctor"}, {{}, RLIM_INFINITY, false, "PATH=/no/such/folder"});
  EXPECT_EQ(program.wait(), 0) << "optional tools may be missing";
  EXPECT_THAT(program.out(), HasSubstr("apt install gtkwave"));
}

TEST_F(CliTest, FullStandardOutputIsAnError) {
  Program program(folder.path(), {"knobs"}, {"/dev/full", RLIM_INFINITY, false, {}});
  EXPECT_EQ(program.wait(), 2);
  EXPECT_THAT(program.err(), HasSubstr("cannot write the standard output: No space left"));
}

}  // namespace
}  // namespace racebeam
