// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/term_picture.h"

#include <gtest/gtest.h>

#include "sc/base/constants.h"
#include "tb/view/term_keys.h"
#include "tests/support/ansi_terminal.h"

namespace racebeam {
namespace {

constexpr const char* HalfBlock = "\xe2\x96\x80";
constexpr TermSize Size{80, 31};  // 30 rows of two pixels: 80 x 60, each the mean of 8 x 8

RgbImage gradient(int shift) {
  RgbImage picture(VisibleColumns, VisibleRows);
  for (int y = 0; y < VisibleRows; ++y)
    for (int x = 0; x < VisibleColumns; ++x)
      picture.dot(x, y,
                  {static_cast<std::uint8_t>(x / 8 + (y > 240 ? shift : 0)),
                   static_cast<std::uint8_t>(y / 8), static_cast<std::uint8_t>(x % 8)});
  return picture;
}

TEST(TermPicture, ACharacterHasTheMeansOfTwoBoxesOfPixels) {
  AnsiTerminal screen(80, 31);
  screen.take(TermPicture().draw(gradient(0), {}, "status", Size));
  for (int row = 0; row < 30; ++row)
    for (int x = 0; x < 80; ++x) {
      const AnsiTerminal::Cell& cell = screen.at(x, row);
      ASSERT_EQ(cell.letter, HalfBlock);
      const auto column = static_cast<std::uint8_t>(x);
      const auto upper = static_cast<std::uint8_t>(2 * row);
      ASSERT_EQ(cell.ink, (Rgb{column, upper, 4}));  // the mean of 0..7 is 3.5
      ASSERT_EQ(cell.paper, (Rgb{column, static_cast<std::uint8_t>(upper + 1), 4}));
    }
  EXPECT_EQ(screen.row(30).substr(0, 8), "status  ");
}

TEST(TermPicture, ChangesAloneMakeTheSameScreenAsAWholePage) {
  TermPicture picture;
  AnsiTerminal changed(80, 31), page(80, 31);
  const std::string first = picture.draw(gradient(0), {}, "one", Size);
  const std::string second = picture.draw(gradient(7), {"word"}, "two", Size);
  changed.take(first);
  changed.take(second);
  page.take(TermPicture().page(gradient(7), {"word"}, "two", Size));
  EXPECT_TRUE(changed.cells() == page.cells());
  EXPECT_LT(second.size(), first.size() * 2 / 3);
}

TEST(TermPicture, WhatHasNotChangedIsNotWritten) {
  TermPicture picture;
  picture.draw(gradient(0), {}, "", Size);
  EXPECT_EQ(picture.draw(gradient(0), {}, "", Size), "");
}

TEST(TermPicture, AnotherSizeIsDrawnAnew) {
  TermPicture picture;
  picture.draw(gradient(0), {}, "", Size);
  AnsiTerminal small(20, 9);
  small.take(picture.draw(gradient(0), {}, "s", {20, 9}));
  EXPECT_EQ(small.at(3, 0).letter, HalfBlock);
  EXPECT_EQ(small.at(0, 8).letter, "s");
}

TEST(TermPicture, KeepsItsShapeAndFitsAnySize) {
  for (const TermSize size :
       {TermSize{200, 20}, TermSize{40, 50}, TermSize{8, 8}, TermSize{1000, 500}}) {
    AnsiTerminal screen(size.columns, size.rows);
    screen.take(TermPicture().draw(RgbImage(640, 480, {9, 9, 9}), {}, "", size));
    int width = 0, height = 0;
    for (int x = 0; x < size.columns; ++x) width += screen.at(x, 0).ink == Rgb{9, 9, 9};
    for (int y = 0; y < size.rows; ++y)
      height += 2 * (screen.at(size.columns / 2, y).ink == Rgb{9, 9, 9});
    EXPECT_GT(width, 0);
    EXPECT_NEAR(width * 3 / 4.0, height, 2.0) << size.columns;
  }
}

TEST(TermKeys, SequencesAreTheNamesOfTheirKeys) {
  using Keys = std::vector<std::string>;
  EXPECT_EQ(term_keys("a B"), (Keys{"a", "space", "b"}));
  EXPECT_EQ(term_keys("\x1b[A\x1bOB\x1b[D."), (Keys{"up", "down", "left", "."}));
  EXPECT_EQ(term_keys("\x1bOP\x1b[24~"), (Keys{"f1", "f12"}));
  EXPECT_EQ(term_keys("\x1b"), Keys{"escape"});
  EXPECT_EQ(term_keys("\x1b[31~x"), Keys{"x"});
}

}  // namespace
}  // namespace racebeam
