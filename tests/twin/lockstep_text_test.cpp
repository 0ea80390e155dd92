// Promises of tb/twin/lockstep_text.h, of differences made by hand.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/lockstep_text.h"

#include <gmock/gmock.h>

#include <cstdint>
#include <functional>
#include <sstream>

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

/// A unit with the inputs rst_ni and a_i, and the outputs x_o of 4 bits and y_o of 1.
struct Made {
  using Of = std::function<std::uint64_t(int)>;  // the clock, 0 that of the difference

  int first = -20, last = 64;
  Of reset = [](int) { return 1; }, input = [](int) { return 7; };
  Of x = [](int) { return 3; }, x_rtl = x;
  Of y = [](int) { return 1; }, y_rtl = y;
  std::uint64_t clock = 1000;

  LockstepDifference difference() const {
    LockstepDifference d;
    d.unit = "made";
    d.port = "x_o";
    d.clock = clock;
    d.before = static_cast<std::size_t>(-first);
    d.expected = x(0);
    d.got = x_rtl(0);
    d.columns = {{"rst_ni", LockstepDifference::Input, 1}, {"a_i", LockstepDifference::Input, 8},
                 {"x_o", LockstepDifference::Model, 4},    {"x_o", LockstepDifference::Rtl, 4},
                 {"y_o", LockstepDifference::Model, 1},    {"y_o", LockstepDifference::Rtl, 1}};
    for (int n = first; n <= last; ++n)
      d.history.push_back({reset(n), input(n), x(n), x_rtl(n), y(n), y_rtl(n)});
    return d;
  }
  std::string hints() const { return difference_hints(difference()); }
  std::vector<std::vector<std::string>> table() const {
    std::istringstream in(difference_table(difference()));
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(in, line);) {
      std::istringstream words(line);
      rows.emplace_back(std::istream_iterator<std::string>(words),
                        std::istream_iterator<std::string>());
    }
    return rows;
  }
};

TEST(LockstepText, EqualClocksAreOneColumnAndEqualSidesOneRow) {
  Made made;
  made.x = [](int n) { return n < -2 ? 3 : 5; };
  made.x_rtl = [](int n) { return n < -2 ? 3 : n < 0 || n == 2 ? 5 : 4; };
  EXPECT_THAT(made.table(),
              ElementsAre(ElementsAre("clock", "-20..-3", "-2..-1", "0", "+1", "+2", "+3..+4"),
                          ElementsAre("rst_ni", "1", "1", "1", "1", "1", "1"),
                          ElementsAre("a_i", "7", "7", "7", "7", "7", "7"),
                          ElementsAre("x_o", "model", "3", "5", "5", "5", "5", "5"),
                          ElementsAre("x_o", "rtl", "3", "5", ">4", ">4", "5", ">4"),
                          ElementsAre("y_o", "both", "1", "1", "1", "1", "1", "1")));
}

TEST(LockstepText, ATableHasTheLastSixteenThingsThatHappened) {
  Made made;
  made.first = -255;
  made.input = [](int n) { return (n & 0xff) / 10; };
  made.x_rtl = [](int n) { return n < 0 ? 3 : 1; };
  const auto rows = made.table();
  ASSERT_EQ(rows[0].size(), 17u);
  EXPECT_EQ(rows[0][16], "+1..+4");
  EXPECT_EQ(rows[0][15], "0");
  EXPECT_EQ(rows[0][14], "-6..-1");
  EXPECT_EQ(rows[0][1], "-136..-127");
}

TEST(LockstepText, NothingIsMarkedBeforeTheFirstComparedClock) {
  Made made;
  made.clock = 20;
  made.x_rtl = [](int n) { return n == -20 || n == 0 ? 9 : 3; };
  const auto rows = made.table();
  EXPECT_THAT(rows[4], ElementsAre("x_o", "rtl", "9", "3", ">9", "3"));
}

TEST(LockstepText, OneClockLateIsSaidOnlyOfAWindowThatProvesIt) {
  Made made;
  made.x = [](int n) { return n < 0 ? 3 : (n / 2 + 4) & 15; };
  made.x_rtl = [&](int n) { return made.x(n - 1); };
  EXPECT_EQ(made.hints(),
            "hint: the RTL is one clock late: in 65 clocks from the difference on its x_o is the "
            "model's of one clock before, through 33 changes\n");
  const auto late = made.x_rtl;
  made.x_rtl = [&](int n) { return n == 50 ? 2 : late(n); };
  EXPECT_THAT(made.hints(), Not(HasSubstr("late")));
  made.x_rtl = late;
  made.x = [](int n) { return n < 0 ? 3 : 4; };
  EXPECT_THAT(made.hints(), Not(HasSubstr("late"))) << "one change proves nothing";
}

TEST(LockstepText, EarlyInvertedStuckAndOneBitAreToldApart) {
  Made made;
  made.x = [](int n) { return n <= 0 ? 3 : (n / 2 + 4) & 15; };
  made.x_rtl = [&](int n) { return made.x(n + 1); };
  EXPECT_THAT(made.hints(), HasSubstr("hint: the RTL is one clock early: in 64 clocks"));
  made.x_rtl = [&](int n) { return n < 0 ? 3 : made.x(n) ^ 15; };
  EXPECT_THAT(made.hints(), HasSubstr("hint: the RTL is inverted: in 65 clocks"));
  made.x = [](int n) { return n < 0 ? 3 : n & 15; };
  made.x_rtl = [](int) { return 3; };
  EXPECT_THAT(made.hints(), HasSubstr("hint: the RTL is stuck: in 65 clocks from the difference on "
                                      "its x_o keeps its value, the model's has 65 changes"));
  made.x_rtl = [&](int n) { return made.x(n) | (n < 0 ? 0 : 4); };
  EXPECT_EQ(made.hints(),
            "hint: one bit: in 65 clocks from the difference on nothing but bit 2 of x_o differs, "
            "in 33 clocks\n");
}

TEST(LockstepText, TellsAResetShortlyBeforeAndWhenItPasses) {
  Made made;
  made.x_rtl = [](int n) { return n == 0 || n == 2 ? 5 : 3; };
  made.reset = [](int n) { return n != -3; };
  EXPECT_THAT(made.hints(),
              HasSubstr("hint: it passes: after 3 clocks all outputs agree again, for "
                        "62 clocks at least\n"));
  EXPECT_THAT(made.hints(), HasSubstr("hint: it begins 3 clocks after a reset by rst_ni\n"));
  made.reset = [](int n) { return n != 0; };
  EXPECT_THAT(made.hints(), HasSubstr("hint: it begins in a reset: rst_ni is active\n"));
  made.reset = [](int n) { return n > -18; };
  EXPECT_THAT(made.hints(), Not(HasSubstr("reset"))) << "too long ago to mean anything";
  made.y_rtl = [](int n) { return n < 60; };
  EXPECT_THAT(made.hints(), Not(HasSubstr("it passes"))) << "another output differs later";
}

TEST(LockstepText, SaysWhatAPortHasInAllDifferencesIfChanceDoesNotExplainIt) {
  Made made;
  made.input = [](int n) { return (n * 7 / 4 + 2) & 3; };  // 2 in one of four
  made.x_rtl = [&](int n) { return made.input(n) == 2 && n >= 0 ? 4 : 3; };
  EXPECT_THAT(made.hints(), HasSubstr("hint: only while a_i is 2: so it is in all "));
  made.x_rtl = [&](int n) { return made.input(n) == 2 && n >= 0 && n < 8 ? 4 : 3; };
  EXPECT_THAT(made.hints(), Not(HasSubstr("only"))) << "a few prove nothing";
  made.x_rtl = [&](int n) { return (made.input(n) == 2 || n == 31) && n >= 0 ? 4 : 3; };
  ASSERT_NE(made.input(31), 2u);
  EXPECT_THAT(made.hints(), Not(HasSubstr("only"))) << "one is otherwise";
  made.input = [](int) { return 2; };
  EXPECT_THAT(made.hints(), Not(HasSubstr("only"))) << "it has nothing else";
}

TEST(LockstepText, ColoursTheMarkedValuesAndNothingElse) {
  EXPECT_EQ(in_colour("x rtl 3 >4a  >5\nverify >out.txt --set a>b"),
            "x rtl 3 \x1b[1;31m>4a\x1b[0m  \x1b[1;31m>5\x1b[0m\nverify >out.txt --set a>b");
}

}  // namespace
}  // namespace racebeam
