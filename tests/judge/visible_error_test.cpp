// Which differences between pictures count as visible: hand-made pictures, and edges of the demo.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/visible_error.h"

#include <gtest/gtest.h>

#include "tb/golden/golden_picture.h"
#include "tests/support/core_picture.h"

namespace racebeam {
namespace {

constexpr std::uint8_t Ground = 1, Wall = 2, Line = 3;

/// A picture of one colour, into which rectangles are drawn.
class Drawing {
 public:
  Drawing& draw(int x, int y, int width, int height, std::uint8_t colour) {
    for (int row = y; row < y + height; ++row)
      for (int column = x; column < x + width; ++column) pixel(column, row) = colour;
    return *this;
  }
  /// The same on every other line from the first one on.
  Drawing& draw_dithered(int x, int y, int width, int height, std::uint8_t even, std::uint8_t odd) {
    for (int row = y; row < y + height; ++row) draw(x, row, width, 1, row % 2 ? odd : even);
    return *this;
  }
  std::uint8_t& pixel(int x, int y) { return picture[y * VisibleColumns + x]; }

  GoldenPicture picture = GoldenPicture(VisibleColumns * VisibleRows, Ground);
};

/// It does not matter which of two pictures is the reference.
int visible(const Drawing& a, const Drawing& b) {
  const int pixels = visible_difference(a.picture, b.picture);
  EXPECT_EQ(visible_difference(b.picture, a.picture), pixels);
  return pixels;
}

Drawing wall_from(int x, int y) {
  return Drawing().draw(x, y, VisibleColumns - x, VisibleRows - y, Wall);
}

TEST(VisibleError, EqualPicturesHaveNone) {
  EXPECT_EQ(visible(wall_from(300, 0), wall_from(300, 0)), 0);
}

TEST(VisibleError, AnEdgeMovedByOnePixelCountsNothing) {
  EXPECT_EQ(visible(wall_from(300, 0), wall_from(301, 0)), 0);
  EXPECT_EQ(visible(wall_from(0, 200), wall_from(0, 201)), 0);
  EXPECT_EQ(visible(wall_from(300, 200), wall_from(301, 201)), 0) << "and its corner";
}

TEST(VisibleError, AnEdgeMovedByTwoPixelsCountsBoth) {
  EXPECT_EQ(visible(wall_from(300, 0), wall_from(302, 0)), 2 * VisibleRows);
  EXPECT_EQ(visible(wall_from(0, 200), wall_from(0, 202)), 2 * VisibleColumns);
}

TEST(VisibleError, AnEdgeAslantMovedByOnePixelCountsNothing) {
  Drawing wall, moved;
  for (int y = 0; y < VisibleRows; ++y) {
    wall.draw(100 + y / 3, y, 200, 1, Wall);
    moved.draw(101 + y / 3, y, 200, 1, Wall);
  }
  EXPECT_EQ(visible(wall, moved), 0);
}

TEST(VisibleError, AHoleCounts) {
  EXPECT_EQ(visible(wall_from(0, 0), wall_from(0, 0).draw(50, 50, 1, 1, Ground)), 1);
  EXPECT_EQ(visible(wall_from(0, 0), wall_from(0, 0).draw(50, 50, 7, 5, Ground)), 35);
}

TEST(VisibleError, ALineOfOnePixelCountsIfItIsLostOrTooMuch) {
  const Drawing with = Drawing().draw(100, 0, 1, VisibleRows, Line);
  EXPECT_EQ(visible(with, Drawing()), VisibleRows);
  EXPECT_EQ(visible(with, Drawing().draw(101, 0, 1, VisibleRows, Line)), 0) << "moved by one";
  EXPECT_EQ(visible(with, Drawing().draw(102, 0, 1, VisibleRows, Line)), 2 * VisibleRows)
      << "lost, and elsewhere too much";
  EXPECT_EQ(visible(Drawing().draw(0, 100, VisibleColumns, 1, Line), Drawing()), VisibleColumns);
}

TEST(VisibleError, AnEdgeBetweenDitheredWallsMovesByOneLineUnseenAndByTwoSeen) {
  const auto edge_at = [](int y) {
    return Drawing()
        .draw_dithered(0, 0, VisibleColumns, y, Ground, Wall)
        .draw_dithered(0, y, VisibleColumns, VisibleRows - y, Line, 4);
  };
  for (const int y : {200, 201}) {
    EXPECT_EQ(visible(edge_at(y), edge_at(y + 1)), 0) << y;
    EXPECT_EQ(visible(edge_at(y), edge_at(y + 2)), 2 * VisibleColumns) << y;
  }
}

TEST(VisibleError, AColourThatEveryOtherLineHasIsNotNearInTheLinesBetween) {
  const Drawing dithered = Drawing().draw_dithered(0, 0, VisibleColumns, VisibleRows, Wall, Line);
  Drawing odd = dithered;
  odd.draw(300, 201, 1, 1, 5);
  EXPECT_EQ(visible(dithered, odd), 1);
}

TEST(VisibleError, TheBorderOfThePictureHasNoPixelsBeyondIt) {
  const std::pair<int, int> places[] = {{0, 0}, {639, 0}, {0, 479}, {639, 479}, {320, 1}, {1, 240}};
  for (const auto& [x, y] : places)
    EXPECT_EQ(visible(Drawing(), Drawing().draw(x, y, 1, 1, Wall)), 1) << x << " " << y;
  EXPECT_EQ(visible(wall_from(639, 479), Drawing().draw(0, 479, 1, 1, Wall)), 2)
      << "the end of a line is not near its start";
  EXPECT_EQ(visible(wall_from(1, 0), wall_from(0, 0)), VisibleRows) << "lost beyond the border";
}

// Rays of ten bits move edges by a pixel here and there; a beam that wins tears holes.
TEST(VisibleError, ForgivesRoundingButNotTheBeam) {
  const auto share = [](int frame, const knobs& k) {
    const GoldenPicture chip = core_picture(frame, k);
    const GoldenPicture ideal =
        golden_picture(GoldenTracer::Geometry, GoldenWorld(frame, k), GoldenCamera(frame));
    return double(visible_difference(chip, ideal)) / golden_difference(chip, ideal);
  };
  EXPECT_LT(share(1537, {}), 0.3);
  knobs fast;
  fast.clocks_per_pixel = 1;
  EXPECT_GT(share(7167, fast), 0.7);
}

}  // namespace
}  // namespace racebeam
