// `racebeam view --tt`: a stranger's chip without a screen, in a terminal, and wrong.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tb/base/text_pattern.h"
#include "tests/cli/program.h"
#include "tests/support/read_picture.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

const std::string Paddle = RACEBEAM_SOURCE_DIR "/tests/tt/paddle";

class CliTtViewTest : public testing::Test {
 protected:
  CliTtViewTest() { setenv("SDL_AUDIODRIVER", "dummy", 1); }
  static Words with(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  /// In the terminal, as text.
  void view(const Words& more, int code = 0) {
    Program program(folder.path(), with({"view", "--tt", Paddle, "--term", "--frames", "1"}, more),
                    {"", RLIM_INFINITY, false, "COLUMNS=160"});
    EXPECT_EQ(program.wait(), code) << program.err();
    out = program.out();
    err = program.err();
  }
  void expect_refused(const Words& more, const std::string& text) {
    view(more, 2);
    EXPECT_THAT(err, HasSubstr(text));
  }
  /// The text on the terminal, as a regular expression; a page of it is too much for a message.
  bool shows(const std::string& text) const { return !TextPattern(text).search(out).empty(); }
  std::string out, err;
  ScratchFolder folder;
};

#ifdef RACEBEAM_WINDOW
TEST_F(CliTtViewTest, WhatAPlayerDidIsReplayedPictureForPicture) {
  const std::string player = "1 o . o u 0 u l l k c c 0 1 . o . o 2 l . o";
  Program window(folder.path(),
                 {"view", "--tt", Paddle, "--paused", "--frames", "1", "--ui", "8", "--keys",
                  player, "--record-inputs", "in.csv", "-o", "shots"},
                 {"", RLIM_INFINITY, false, "SDL_VIDEODRIVER=dummy"});
  ASSERT_EQ(window.wait(), 0) << window.err();
  EXPECT_THAT(window.err(), HasSubstr("wrote in.csv"));
  EXPECT_THAT(read_file(folder / "in.csv"), HasSubstr("reset,0,0,8,0\n1,-273,0,10,0\n"));
  Program render(folder.path(),
                 {"render", "--tt", Paddle, "--inputs", "in.csv", "--frames", "5", "-o", "out"});
  ASSERT_EQ(render.wait(), 0) << render.err();
  int shots = 0, kinds = 0;
  for (int frame = 0; frame < 5; ++frame) {
    const std::string number = "000" + std::to_string(frame) + ".png";
    const Picture seen = read_picture(folder / ("shots/view_" + number));
    if (seen.empty()) continue;
    ++shots;
    kinds += frame > 0 && seen != read_picture(folder / "out/frame_0000.png");
    EXPECT_EQ(seen, read_picture(folder / ("out/frame_" + number))) << frame;
  }
  EXPECT_EQ(shots, 5);
  EXPECT_GE(kinds, 3) << "the inputs matter";
}
#endif

TEST_F(CliTtViewTest, TheTitleTellsFrameAndInputs) {
  view({"--ui", "1", "--uio", "2", "--keys", "5 u 0"});
  EXPECT_TRUE(shows("tt_um_paddle 0 ui 00000001 uio 00000010"));
  EXPECT_TRUE(shows("ui 00100001 uio 00000010"));
  EXPECT_TRUE(shows("ui 00100001 uio 00000011 - keys: uio"));
}

TEST_F(CliTtViewTest, HelpHasTheKeysOfTheChipAndNotOfTheModel) {
  view({"--keys", "h m"});
  EXPECT_TRUE(shows("ui_in.0. to ui_in.3."));
  EXPECT_TRUE(shows("step a frame"));
  EXPECT_FALSE(shows("map of slack"));
  EXPECT_FALSE(shows("free flight"));
}

TEST_F(CliTtViewTest, KeysOfTheModelSaySo) {
  for (const char* key : {"i", "g", "f", "f5"}) {
    view({"--keys", key});
    EXPECT_TRUE(shows("of the model only")) << key;
  }
}

TEST_F(CliTtViewTest, StatisticsShowThePins) {
  view({"--ui", "2", "--keys", "t m"});
  EXPECT_TRUE(shows("ui_in +00000010"));
  EXPECT_TRUE(shows("uio_oe +10000000"));
  EXPECT_TRUE(shows("uio_out.7."));
  EXPECT_FALSE(shows("decisions"));
}

TEST_F(CliTtViewTest, InputsAreWrittenByAKeyToo) {
  view({"--keys", "1 w", "-o", "shots"});
  EXPECT_EQ(read_file(folder / "shots/view_0000.csv"),
            "frame,line,clock,ui,uio\nreset,0,0,0,0\n1,-273,0,2,0\n");
}

TEST_F(CliTtViewTest, RefusesWhatItCannotDo) {
  for (const Words& words :
       {Words{"demo"}, {"--set", "speed=1"}, {"--use", "all=rtl"}, {"--level", "tlm"}})
    expect_refused(words, "--tt runs a chip of its own; leave out " +
                              (words[0] == "demo" ? "the scene" : words[0]));
  expect_refused({"--sound-pin", "8"}, "--sound-pin 8 is out of range");
  expect_refused({"--ui", "256"}, "--ui 256 is out of range");
  expect_refused({"--keys", "8"}, "unknown key '8'");
  expect_refused({"--inputs", "none.csv"}, "none.csv cannot be read");
  Program scene(folder.path(), {"view", "demo", "--term", "--frames", "1", "--ui", "1"});
  EXPECT_EQ(scene.wait(), 2);
  EXPECT_THAT(scene.err(), HasSubstr("--tt"));
}

}  // namespace
}  // namespace racebeam
