// `racebeam render --against`: the model, and RTL, held to the checksums of the taped-out chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>

#include "tests/cli/program.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

const std::string Reference = RACEBEAM_SOURCE_DIR "/tests/reference/chip_frames.csv";

class CliAgainstTest : public testing::Test {
 protected:
  Words render(const Words& what, const std::string& reference, const Words& more = {}) {
    Words words = {"render"};
    words.insert(words.end(), what.begin(), what.end());
    words.insert(words.end(), {"--against", reference});
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  std::string file(const std::string& text) {
    std::ofstream(folder / "F.csv") << text;
    return "F.csv";
  }
  /// Picture and pins of a frame of the taped-out chip: "0e8cd7a6,a6f1481f".
  static std::string checksums(int frame) { return all.substr(place(frame), Both); }
  /// The taped-out chip's checksums with other ones for a frame.
  std::string changed(int frame, const std::string& other) {
    return file(std::string(all).replace(place(frame), Both, other));
  }
  Json against(const Words& words, int code) {
    Program run(folder.path(), words);
    EXPECT_EQ(run.wait(), code) << run.err();
    return run.json()["against"];
  }
  void expect_refused(const std::string& reference, const std::string& said) {
    Program run(folder.path(), render({"demo"}, reference));
    EXPECT_EQ(run.wait(), 2);
    EXPECT_THAT(run.err(), HasSubstr(said));
  }

  ScratchFolder folder;

 private:
  static constexpr std::size_t Both = 17;  // characters of both checksums
  static std::size_t place(int frame) {
    const std::string start = "\n" + std::to_string(frame) + ",";
    return all.find(start) + start.size();
  }
  inline static const std::string all = read_file(Reference);
};

// Every 213th frame: some of each part, and of every scene of the parts that change it twice a bar.
TEST_F(CliAgainstTest, FramesAllOverTheDemoAreTheTapedOutChips) {
  const Json found = against(
      render({"demo"}, "demo", {"--frames", "61", "--every", "213", "--jobs", "2", "--json"}), 0);
  EXPECT_EQ(found["compared"], 61);
  EXPECT_EQ(found["equal"], 61);
  EXPECT_EQ(found["missing"], Json::array());
  EXPECT_TRUE(found["first"].is_null());
}

TEST_F(CliAgainstTest, RtlBehindTinyTapeoutPinsIsTheTapedOutChip) {
  Program run(folder.path(),
              render({"--tt", RACEBEAM_SOURCE_DIR "/rtl"}, "demo", {"--frames", "3"}));
  EXPECT_EQ(run.wait(), 0) << run.err();
  EXPECT_THAT(run.out(), HasSubstr("\n3 of 3 frames equal the taped-out chip's: picture and pins"));
}

TEST_F(CliAgainstTest, OtherKnobsAreAnotherChip) {
  Program run(folder.path(),
              render({"demo"}, "demo", {"--first", "7223", "--set", "interval_stack_depth=1"}));
  EXPECT_EQ(run.wait(), 1);
  EXPECT_THAT(run.out(), HasSubstr("0 of 1 frame equal the taped-out chip's"));
  EXPECT_THAT(run.err(), HasSubstr("frame 7223 is the first of 1 that differ"));
}

TEST_F(CliAgainstTest, TheFirstWrongFrameIsToldWithBothValues) {
  const std::string right = checksums(4);
  Program run(folder.path(),
              render({"demo"}, changed(4, "12345678,9abcdef0"), {"--first", "2", "--frames", "4"}));
  EXPECT_EQ(run.wait(), 1);
  EXPECT_THAT(run.out(), HasSubstr("3 of 4 frames equal those of F.csv: picture and pins"));
  EXPECT_THAT(run.err(),
              HasSubstr("frame 4 is the first of 1 that differ from those of F.csv; "
                        "picture: expected 12345678, got " +
                        right.substr(0, 8) + "; pins: expected 9abcdef0, got " + right.substr(9)));
}

TEST_F(CliAgainstTest, ThePinsAloneMayDiffer) {
  const std::string wrong = checksums(3).substr(0, 8) + ",00000001";
  const Json found = against(render({"demo"}, changed(3, wrong), {"--frames", "5", "--json"}), 1);
  EXPECT_EQ(found["first"]["frame"], 3);
  EXPECT_FALSE(found["first"].contains("image_crc32"));
  EXPECT_EQ(found["first"]["pins_crc32"]["expected"], "00000001");
  EXPECT_EQ(found["equal"], 4);
}

TEST_F(CliAgainstTest, AReferenceMayHaveSomeFramesAndOneChecksum) {
  std::string rows = "frame,pins_crc32\r\n";
  for (const int frame : {9, 2})
    rows += std::to_string(frame) + checksums(frame).substr(8) + "\r\n\r\n";
  Program run(folder.path(), render({"demo"}, file(rows), {"--frames", "10", "--jobs", "2"}));
  EXPECT_EQ(run.wait(), 0) << run.err();
  EXPECT_THAT(run.out(), HasSubstr("2 of 2 frames equal those of F.csv: pins\n"
                                   "not compared: 8 frames that it does not have: 0, 1, 3, 4, 5, "
                                   "...\n"));
}

TEST_F(CliAgainstTest, WhatCannotBeComparedIsRefused) {
  expect_refused("F.csv", "F.csv cannot be read");
  expect_refused(file("number,crc\n0,1\n"), "F.csv:1:1: the first line must be `frame,image_crc32");
  expect_refused(file("frame,image_crc32\n"), "F.csv has no frames");
  expect_refused(file("frame,image_crc32\n0,1\n1\n"), "F.csv:3:1: 1 values instead of 2");
  expect_refused(file("frame,pins_crc32\n0,123456789\n"), "F.csv:2:3: pins_crc32 is '123456789'");
  expect_refused(file("frame,pins_crc32\n0,1\n0,1\n"), "F.csv:3:1: frame is 0 a second time");
  expect_refused(file("frame,pins_crc32\n-1,1\n"), "F.csv:2:1: frame is -1");
  expect_refused(file("frame,pins_crc32\n7,1\n9,1\n"),
                 "--against F.csv has none of these frames; it has 2 frames from 7 to 9");
  Program golden(folder.path(), render({"demo"}, "demo", {"--golden", "trace2"}));
  EXPECT_EQ(golden.wait(), 2);
  EXPECT_THAT(golden.err(), HasSubstr("--against needs the chip"));
}

TEST_F(CliAgainstTest, FilesAreWrittenOnlyWhenAskedFor) {
  Program check(folder.path(), render({"demo"}, "demo"));
  EXPECT_EQ(check.wait(), 0) << check.err();
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_THAT(check.err(), Not(HasSubstr("wrote")));
  Program files(folder.path(), render({"demo"}, "demo", {"-o", "out"}));
  EXPECT_EQ(files.wait(), 0) << files.err();
  EXPECT_EQ(read_json(folder / "out/stats.json")["against"]["equal"], 1);
}

}  // namespace
}  // namespace racebeam
