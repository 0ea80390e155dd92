// The sphere tracer as a source of pictures for the viewer: what is shown, and the board.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/sphere_source.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tb/host/sphere_picture.h"
#include "tb/view/view_control.h"
#include "tests/support/document.h"

namespace racebeam {
namespace {

constexpr int Pictures = 50;

/// Small pictures: cheap.
SphereProgram moving() {
  SphereProgram program = builtin_sphere_program();
  program.modes = 0;  // 320 x 240
  program.set_start(false);
  for (MovingSphere& sphere : program.moving) sphere.velocity = {0.5, 0.25, 0};
  return program;
}

class SphereSourceTest : public testing::Test {
 protected:
  void frame() { source.advance(source.clocks_left()); }
  std::uint32_t shown(int x, int y) const {
    return source.picture()->colour(static_cast<std::size_t>(y) * 640 + static_cast<unsigned>(x));
  }
  /// The picture is the core's own, the rest is black.
  void expect_picture(int picture) {
    const auto core = core_before(program, {}, picture);
    core->draw(program.board_in(picture));
    const auto words = core->picture();
    ASSERT_EQ(source.watch().frame(), picture);
    for (int y = 0; y < 480; y += 3)
      for (int x = 0; x < 640; x += 3) {
        const bool in = x < 320 && y < 240;
        const auto word = in ? words[static_cast<std::size_t>(core->address(x, y))] & 0x7fff : 0;
        ASSERT_EQ(shown(x, y), word) << x << "," << y;
      }
  }

  const SphereProgram program = moving();
  SphereSource source{program, {}, Pictures};
};

TEST_F(SphereSourceTest, ShowsPictureAfterPicture) {
  for (int picture = 0; picture < 3; ++picture) {
    frame();
    EXPECT_TRUE(source.watch().whole());
    expect_picture(picture);
  }
  EXPECT_TRUE(source.as_in_scene());
}

TEST_F(SphereSourceTest, SeekGivesWhatWatchingGives) {
  source.seek(20);
  frame();
  expect_picture(20);
  source.seek(4);
  frame();
  expect_picture(4);
}

TEST_F(SphereSourceTest, AFrameOfTheViewerLastsAsLongAsThePicture) {
  frame();
  const double seconds = source.watch().raster().frame_clocks() / source.clock_hz();
  EXPECT_GT(seconds, 320 * 240 * 23 / 25.2e6);
  EXPECT_LT(seconds, 320 * 240 * 60 / 25.2e6);
}

TEST_F(SphereSourceTest, PartOfAFrameShowsTheRowsSoFar) {
  frame();
  const auto before = *source.picture();
  const int all = source.watch().raster().frame_clocks();
  EXPECT_EQ(source.advance(all / 2), all / 2);
  EXPECT_FALSE(source.watch().whole());
  const std::size_t middle = std::size_t{2} * 640 * 120;
  EXPECT_EQ(std::vector<std::uint8_t>(before.colours.begin() + middle, before.colours.end()),
            std::vector<std::uint8_t>(source.picture()->colours.begin() + middle,
                                      source.picture()->colours.end()));
  frame();
  expect_picture(1);
}

TEST_F(SphereSourceTest, SwitchesAndKeysActOnTheNextPictures) {
  const auto row = [&](const std::string& name) {
    for (const auto& [title, value] : source.rows())
      if (title == name) return value;
    return std::string("none");
  };
  frame();
  source.press(BoardPins{1 << 11 | 1 << 5, 1});  // the eye to the right, large, wider
  EXPECT_EQ(row("SW17..SW0"), "000000100000100000");
  EXPECT_EQ(row("KEY3..KEY0"), "0001");
  EXPECT_FALSE(source.as_in_scene());
  frame();
  EXPECT_EQ(source.board(), (BoardPins{1 << 11 | 1 << 5, 0})) << "KEY0 comes up by itself";
  EXPECT_EQ(shown(500, 400), 0u) << "the size is taken over at the end of the picture";
  const std::uint32_t white = shown(396, 380);
  source.press(BoardPins{1 << 5, 0});
  frame();
  EXPECT_NE(shown(398, 380), white) << "512 x 480: the light is there";
  source.press(BoardPins{0, 1 << 3 | 1 << 2});  // KEY3 with KEY2: reset, planes on
  frame();
  EXPECT_EQ(source.board(), (BoardPins{0, 1 << 2})) << "KEY2 is held";
}

class BoardKeys : public testing::Test {
 protected:
  BoardKeys() { control.state.board.emplace(); }
  ViewControl control;
};

TEST_F(BoardKeys, NumbersTurnSwitchesAndLettersPressKeys) {
  for (int number = 0; number < 10; ++number) {
    EXPECT_TRUE(control.press(std::to_string(number)));
    EXPECT_EQ(control.state.board, (BoardPins{1 << number, 0}));
    EXPECT_TRUE(control.press(std::to_string(number)));
  }
  for (const char* key : {"u", "7", "8", "u", "1", "a", "w"}) EXPECT_TRUE(control.press(key));
  EXPECT_EQ(control.state.board, (BoardPins{1 << 17 | 1 << 1, 1 << 0 | 1 << 3}));
}

TEST_F(BoardKeys, EveryKeyOfTheHelpDoesSomethingAndThePageListsIt) {
  const std::string text = page("docs/look-inside.md");
  for (const KeyHelp& row : ViewControl::help(KeyHelp::Board)) {
    EXPECT_NE(row.chip, KeyHelp::Model) << row.meaning;
    std::istringstream words(row.keys);
    std::string line = "|";
    for (std::string key; words >> key; line += " `" + key + "`")
      EXPECT_TRUE(control.press(key)) << key;
    line += " | " + row.meaning + " |";
    EXPECT_NE(text.find("\n" + line + "\n"), std::string::npos) << line;
  }
}

TEST_F(BoardKeys, KeysOfTheModelAloneAreToldToBeThat) {
  for (const char* key : {"i", "g", "f", "f5", "e", "x", "up"}) {
    EXPECT_TRUE(control.press(key)) << key;
    EXPECT_EQ(control.take_action(), ViewAction::ModelOnly) << key;
  }
}

}  // namespace
}  // namespace racebeam
