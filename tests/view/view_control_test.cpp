// The viewer's keys, without a window.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/view_control.h"

#include <gtest/gtest.h>

#include <sstream>

#include "tests/support/document.h"

namespace racebeam {
namespace {

TEST(ViewControl, EveryKeyOfTheHelpDoesSomethingAndNoOther) {
  int keys = 0;
  for (const KeyHelp& row : ViewControl::help()) {
    std::istringstream words(row.keys);
    for (std::string key; words >> key; ++keys) EXPECT_TRUE(ViewControl().press(key)) << key;
  }
  EXPECT_EQ(keys, 40);
  for (const char* key : {"n", "y", "f2", "return", ""}) EXPECT_FALSE(ViewControl().press(key));
}

TEST(ViewControl, ThePageListsEveryKey) {
  const std::string text = page("docs/look-inside.md");
  for (const KeyHelp& row : ViewControl::help()) {
    std::istringstream words(row.keys);
    std::string line = "|";
    for (std::string key; words >> key;) line += " `" + key + "`";
    line += " | " + row.meaning + " |";
    EXPECT_NE(text.find("\n" + line + "\n"), std::string::npos) << line;
  }
}

TEST(ViewControl, SpacePausesAndGoesOn) {
  ViewControl control;
  control.press("space");
  EXPECT_TRUE(control.state.paused);
  control.press("p");
  EXPECT_FALSE(control.state.paused);
}

TEST(ViewControl, AStepPausesFirst) {
  for (const auto& [key, action] :
       {std::pair{".", ViewAction::StepFrame}, std::pair{"l", ViewAction::StepLine},
        std::pair{"j", ViewAction::StepTenLines}, std::pair{"k", ViewAction::StepPixel},
        std::pair{"c", ViewAction::StepClock}}) {
    ViewControl control;
    control.press(key);
    EXPECT_TRUE(control.state.paused);
    EXPECT_EQ(control.take_action(), action);
    EXPECT_FALSE(control.take_action());
  }
}

TEST(ViewControl, ActionsComeInTheOrderOfTheKeys) {
  ViewControl control;
  for (const char* key : {"o", "r", "v", "right"}) control.press(key);
  EXPECT_EQ(control.take_action(), ViewAction::Screenshot);
  EXPECT_EQ(control.take_action(), ViewAction::Rewind);
  EXPECT_EQ(control.take_action(), ViewAction::Record);
  EXPECT_EQ(control.take_action(), ViewAction::Forward);
  EXPECT_FALSE(control.take_action());
}

TEST(ViewControl, AMapReplacesAnotherAndItsOwnKeyTakesItAway) {
  ViewControl control;
  control.press("1");
  EXPECT_EQ(control.state.map, MapKind::Slack);
  control.press("3");
  EXPECT_EQ(control.state.map, MapKind::Depth);
  control.press("3");
  EXPECT_FALSE(control.state.map);
  control.press("2");
  control.press("0");
  EXPECT_FALSE(control.state.map);
}

TEST(ViewControl, SpeedStaysWithinItsRange) {
  ViewControl control;
  for (int i = 0; i < 40; ++i) control.press("+");
  EXPECT_EQ(control.state.speed, ViewControl::FastestSpeed);
  for (int i = 0; i < 40; ++i) control.press("-");
  EXPECT_EQ(control.state.speed, ViewControl::SlowestSpeed);
}

TEST(ViewControl, ArrowsLeapOnThePathAndTurnInAFreeFlight) {
  ViewControl control;
  control.press("left");
  EXPECT_EQ(control.take_action(), ViewAction::Back);
  control.release("left");
  control.state.flying = true;
  control.press("left");
  EXPECT_FALSE(control.take_action());
  EXPECT_EQ(control.take_motion().turn, -1);
  control.release("left");
  EXPECT_EQ(control.take_motion().turn, 0);
}

TEST(ViewControl, OppositeKeysCancelAndALostWindowLetsAllGo) {
  ViewControl control;
  control.state.flying = true;
  control.press("w");
  control.press("a");
  control.press("d");
  control.press("e");
  const auto motion = control.take_motion();
  EXPECT_EQ(motion.ahead, 1);
  EXPECT_EQ(motion.right, 0);
  EXPECT_EQ(motion.up, 1);
  control.release_all();
  EXPECT_EQ(control.take_motion().ahead, 0);
}

TEST(ViewControl, AKeyThatWentDownAndUpBetweenTwoLooksMovesOnce) {
  ViewControl control;
  control.state.flying = true;
  EXPECT_FALSE(control.steered());
  control.press("w");
  control.release("w");
  EXPECT_TRUE(control.steered());
  EXPECT_EQ(control.take_motion().ahead, 1);
  EXPECT_FALSE(control.steered());
  EXPECT_EQ(control.take_motion().ahead, 0);
}

TEST(ViewControl, AKeyOfTheFlightOutOfItIsAnswered) {
  ViewControl control;
  control.press("w");
  EXPECT_EQ(control.take_action(), ViewAction::FlightHint);
  control.press("left");
  EXPECT_EQ(control.take_action(), ViewAction::Back);
  EXPECT_FALSE(control.take_action());
}

TEST(ViewControl, AClickAsksToExplainItsPixel) {
  ViewControl control;
  control.click(639, 0);
  EXPECT_EQ(control.take_action(), ViewAction::Explain);
  EXPECT_EQ(control.clicked().column, 639);
  EXPECT_EQ(control.clicked().row, 0);
}

TEST(ViewControl, TheMouseCountsInAFreeFlightOnly) {
  ViewControl control;
  control.mouse(5, 6);
  EXPECT_EQ(control.take_mouse().right, 0);
  control.state.flying = true;
  control.mouse(5, -6);
  control.mouse(1, 1);
  const auto look = control.take_mouse();
  EXPECT_EQ(look.right, 6);
  EXPECT_EQ(look.down, -5);
  EXPECT_EQ(control.take_mouse().right, 0);
}

}  // namespace
}  // namespace racebeam
