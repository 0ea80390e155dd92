// The viewer's keys of a chip that is not our own: its inputs, and what of the model it has not.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <sstream>

#include "tb/view/view_control.h"
#include "tests/support/document.h"

namespace racebeam {
namespace {

class TileKeys : public testing::Test {
 protected:
  TileKeys() { control.state.inputs.emplace(); }
  ViewControl control;
};

TEST_F(TileKeys, ANumberTogglesItsInput) {
  for (int pin = 0; pin < 8; ++pin) {
    EXPECT_TRUE(control.press(std::to_string(pin)));
    EXPECT_EQ(control.state.inputs, (TilePins{static_cast<std::uint8_t>(1 << pin), 0}));
    EXPECT_TRUE(control.press(std::to_string(pin)));
    EXPECT_EQ(control.state.inputs, TilePins());
  }
  for (const char* key : {"u", "7", "u", "1"}) EXPECT_TRUE(control.press(key));
  EXPECT_EQ(control.state.inputs, (TilePins{2, 0x80}));
  EXPECT_FALSE(control.press("8"));
}

TEST_F(TileKeys, EveryKeyOfTheModelAloneIsToldToBeOne) {
  int keys = 0;
  for (const KeyHelp& row : ViewControl::help()) {
    std::istringstream words(row.keys);
    for (std::string key; words >> key;) {
      const bool number = key.size() == 1 && key[0] >= '0' && key[0] <= '7';
      const bool both = number || key == "w" || key == "h" || key == "f1";
      if (row.chip != KeyHelp::Model || both) continue;
      ++keys;
      EXPECT_TRUE(control.press(key)) << key;
      EXPECT_EQ(control.take_action(), ViewAction::ModelOnly) << key;
    }
  }
  EXPECT_EQ(keys, 11) << "i g f f5 a s d e x up down";
  EXPECT_FALSE(control.state.borders || control.state.gauges || control.state.map);
}

TEST_F(TileKeys, EveryKeyOfItsHelpDoesSomethingAndThePagesListIt) {
  const std::string pages = page("docs/look-inside.md") + page("docs/tiny-tapeout.md");
  for (const KeyHelp& row : ViewControl::help(KeyHelp::Tile)) {
    EXPECT_NE(row.chip, KeyHelp::Model) << row.meaning;
    std::istringstream words(row.keys);
    std::string line = "|";
    for (std::string key; words >> key; line += " `" + key + "`")
      EXPECT_TRUE(control.press(key)) << key;
    line += " | " + row.meaning + " |";
    EXPECT_NE(pages.find("\n" + line + "\n"), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace racebeam
