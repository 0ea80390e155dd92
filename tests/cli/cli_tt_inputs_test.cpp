// Inputs of a Tiny Tapeout chip that change in time: `--inputs`.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <fstream>

#include "tests/cli/program.h"
#include "tests/support/read_picture.h"

namespace racebeam {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

const std::string Paddle = RACEBEAM_SOURCE_DIR "/tests/tt/paddle";
constexpr int White = 0x3f, Blue = 0x03;

class CliTtInputsTest : public testing::Test {
 protected:
  void write(const std::string& rows) {
    std::ofstream(folder / "in.csv") << "frame,line,clock,ui,uio\n" << rows;
  }
  /// The pictures of frames 0 to count - 1.
  std::vector<Picture> render(int count, const Words& more = {"--inputs", "in.csv"}) {
    Words words = {"render", "--tt", Paddle,       "--frames", std::to_string(count),
                   "-o",     "out",  "--overwrite"};
    words.insert(words.end(), more.begin(), more.end());
    Program run(folder.path(), words);
    EXPECT_EQ(run.wait(), 0) << run.err();
    std::vector<Picture> pictures;
    for (int frame = 0; frame < count; ++frame)
      pictures.push_back(read_picture(folder / ("out/frame_000" + std::to_string(frame) + ".png")));
    return pictures;
  }
  /// Column of the bar's left edge, of a picture that is good but for that.
  static int left_of(const Picture& picture) {
    int left = 0;
    while (left < 576 && picture.at(left) != White) ++left;
    for (int y = 0; y < 480; ++y)
      for (int x = 0; x < 640; ++x)
        EXPECT_EQ(picture.at(y * 640 + x), x >= left && x < left + 64 ? White : 0)
            << x << ", " << y;
    return left;
  }
  void expect_refused(const std::string& text, const std::string& said) {
    std::ofstream(folder / "in.csv") << text;
    Program run(folder.path(), {"render", "--tt", Paddle, "--inputs", "in.csv"});
    EXPECT_EQ(run.wait(), 2);
    EXPECT_THAT(run.err(), HasSubstr(said));
  }

  ScratchFolder folder;
};

TEST_F(CliTtInputsTest, EachFrameMovesTheBarAsTheInputsBeforeItsPictureSay) {
  write("1,-273,0,1,0\n3,0,0,2,0\n5,-273,0,0,0\n");
  const std::vector<Picture> pictures = render(7);
  const int lefts[] = {288, 280, 272, 264, 272, 272, 272};
  for (int frame = 0; frame < 7; ++frame)
    EXPECT_EQ(left_of(pictures[frame]), lefts[frame]) << "frame " << frame;
}

// The frames are found by their syncs, which takes more than a frame: inputs count from the reset.
TEST_F(CliTtInputsTest, TheFirstFramesHaveTheirInputsThough) {
  write("0,-273,0,1,0\n1,-273,0,0,0\n");
  const std::vector<Picture> pictures = render(3);
  for (const Picture& picture : pictures) EXPECT_EQ(left_of(picture), 280);
}

TEST_F(CliTtInputsTest, TheLogicSeesAnInputAClockLater) {
  write("0,-140,500,4,0\n0,-140,600,0,0\n");
  const Picture picture = render(1)[0];
  for (int x = 0; x < 640; ++x) {
    const bool bar = x >= 288 && x < 352, blue = x >= 500 - 160 + 1 && x < 600 - 160 + 1;
    ASSERT_EQ(picture.at(100 * 640 + x), bar ? White : blue ? Blue : 0) << x;
    ASSERT_EQ(picture.at(101 * 640 + x), bar ? White : 0) << x;
  }
}

TEST_F(CliTtInputsTest, ResetGivesTheInputsFromTheResetOn) {
  write("reset,0,0,0x02,0\n\n 2 , -273,\t0,0,0\r\n");
  const std::vector<Picture> file = render(3);
  EXPECT_EQ(left_of(file[0]), 296);
  EXPECT_EQ(left_of(file[1]), 304);
  EXPECT_EQ(left_of(file[2]), 304);
  EXPECT_EQ(render(2, {"--ui", "2"}), (std::vector<Picture>{file[0], file[1]}));
  write("2,-273,0,0,0\n");
  EXPECT_EQ(render(3, {"--ui", "2", "--inputs", "in.csv"}), file);
}

TEST_F(CliTtInputsTest, StatisticsTellHowManyInputsChange) {
  write("reset,0,0,1,2\n4,0,0,0,0\n");
  Program run(folder.path(), {"render", "--tt", Paddle, "--inputs", "in.csv", "--json"});
  const Json chip = run.json()["chip"];
  EXPECT_EQ(chip["ui_in"], 1);
  EXPECT_EQ(chip["uio_in"], 2);
  EXPECT_EQ(chip["input_changes"], 1);
}

TEST_F(CliTtInputsTest, FaultsNameFileLineAndColumn) {
  const std::string head = "frame,line,clock,ui,uio\n";
  expect_refused("", "in.csv:0:1: the first line must be `frame,line,clock,ui,uio`");
  expect_refused("0,0,0,0,0\n", "in.csv:1:1: the first line must be");
  expect_refused(head + "0,0,0,0\n", "in.csv:2:1: 4 values instead of 5");
  expect_refused(head + "0,0,0,256,0\n", "in.csv:2:7: ui is 256, must be 0..255");
  expect_refused(head + "0,0,0,0, x\n", "in.csv:2:10: uio is 'x', must be a number, 0..255");
  expect_refused(head + "0,0,,0,0\n", "in.csv:2:5: clock is '', must be a number");
  expect_refused(head + "-1,0,0,0,0\n", "in.csv:2:1: frame is -1, must be 0..999999");
  expect_refused(head + "\n2,0,0,0,0\n1,9,9,0,0\n", "in.csv:4:1: frame and line and clock are not");
  expect_refused(head + "2,0,0,0,0\n2,0,0,1,0\n", "in.csv:3:1: frame and line and clock are not");
  expect_refused(head + "2,0,0,0,0\nreset,0,0,1,0\n", "in.csv:3:1: frame is reset, which only");
  expect_refused(head + "reset,0,5,1,0\n", "in.csv:2:9: clock is 5, must be 0..0");
  expect_refused(head + "2,252,0,1,0\n",
                 "in.csv:2: line is 252; the frames of this chip have -273..251");
  expect_refused(head + "2,251,800,1,0\n",
                 "in.csv:2: clock is 800; the frames of this chip have 0..799");
  Program run(folder.path(), {"render", "--tt", Paddle, "--inputs", "no.csv"});
  EXPECT_EQ(run.wait(), 2);
  EXPECT_THAT(run.err(), HasSubstr("no.csv cannot be read"));
  Program scene(folder.path(), {"render", "demo", "--inputs", "in.csv"});
  EXPECT_EQ(scene.wait(), 2);
  EXPECT_THAT(scene.err(), HasSubstr("--ui, --uio and --inputs"));
}

}  // namespace
}  // namespace racebeam
