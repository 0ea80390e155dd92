// The figures of docs/: drawn from the chip's own numbers, and as they stand in the pages.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/figures.h"

#include <gmock/gmock.h>

#include "tb/base/errors.h"
#include "tb/base/text_pattern.h"
#include "tb/explain/explanation.h"
#include "tb/explain/ray_walk.h"
#include "tb/golden/golden_camera.h"
#include "tests/support/document.h"

namespace racebeam {
namespace {

using testing::Each;
using testing::HasSubstr;

TEST(RayWalk, HasTheRaysOfTheGoldenCamera) {
  const Show demo;
  for (const auto& [frame, y] : {std::pair{1000, 0}, std::pair{5000, -17}, std::pair{9100, 200}}) {
    const LineRays rays = line_rays(demo, {}, frame, y);
    const GoldenRays golden = GoldenCamera(frame).rays(y);
    for (int pixel = 0; pixel < VisibleColumns; pixel += 7)
      EXPECT_EQ(rays.ray(pixel, {}), golden[pixel]) << frame << " " << y << " " << pixel;
  }
}

/// What the tracer did with the pixel's interval, of all that its line did.
void expect_same_way(int frame, int column, int row) {
  SCOPED_TRACE(std::to_string(frame) + ": " + std::to_string(column) + "," + std::to_string(row));
  const Show demo;
  const Explanation e(demo, {}, frame, column, row);
  ASSERT_EQ(e.fate, PixelFate::InTime);
  const RayWalk walk(demo, {}, frame, row + FirstVisibleLine, e.pixel());
  EXPECT_EQ(walk.wall, e.interval->axis);
  EXPECT_EQ(walk.negative(walk.wall), e.interval->negative);
  std::vector<int> rooms, told;
  for (const RayQuestion& q : walk.questions)
    if (q.step.level == 6) rooms.push_back(q.step.room);
  for (const RoomOnWay& room : e.interval->way) told.push_back(room.room);
  EXPECT_EQ(rooms, told);
}

TEST(RayWalk, GoesTheWayOfTheInterval) {
  expect_same_way(1000, 320, 240);
  expect_same_way(60, 100, 30);
  expect_same_way(5000, 600, 470);
  expect_same_way(7000, 5, 3);
  expect_same_way(11000, 320, 200);
}

TEST(RayWalk, AsksTheQuestionsOfEachRoomInOrder) {
  const RayWalk walk(Show(), {}, 1000, 0, 319);
  std::string levels;
  for (const RayQuestion& q : walk.questions) levels += std::to_string(q.step.level);
  EXPECT_TRUE(TextPattern("267(012367)*").matches(levels)) << levels;
  for (const RayQuestion& q : walk.questions)
    if (q.step.depth > 0 && q.step.level < 4) {
      EXPECT_EQ(q.step.answer, 0) << "or it would end";
    }
}

TEST(Figures, AreThoseOfThePages) {
  for (const Figure& figure : figures()) {
    const std::string path = "docs/figures/" + std::string(figure.name) + ".svg";
    EXPECT_TRUE(page(path) == figure.draw({Show(), {}, 700, -140, 184}))
        << path << " is not what the program draws; scripts/pictures makes it anew";
  }
}

TEST(Figures, AreDrawnOfAnyPixelThatHasOne) {
  const Show demo;
  for (const int frame : {0, 2600, 5555, 7223, 12798})
    for (const int pixel : {0, 255, 638})
      for (const Figure& figure : figures()) {
        SCOPED_TRACE(figure.name + (" of frame " + std::to_string(frame)));
        try {
          const std::string svg = figure.draw({demo, {}, frame, 101, pixel});
          EXPECT_THAT(svg, HasSubstr("</svg>\n"));
          for (const char* nonsense : {"nan", "inf", "e+"})
            EXPECT_EQ(svg.find("\"" + std::string(nonsense)), std::string::npos);
        } catch (const UsageError& error) {
          EXPECT_STREQ(figure.name, "portal") << error.what();
        }
      }
}

// What the table says a bit adds is what the chip's ray gains.
TEST(Figures, TheStepTableAddsUp) {
  const Show demo;
  for (const auto& [frame, pixel] :
       {std::pair{1000, 319}, std::pair{1400, 638}, std::pair{5000, 77}}) {
    const std::string svg = figure("step-table").draw({demo, {}, frame, 0, pixel});
    const TextPattern::Groups found =
        TextPattern("(-?\\d+) in all: ([xyz]) of the ray goes from (-?\\d+) to (-?\\d+)")
            .search(svg);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(std::stoi(found[3]) + std::stoi(found[1]), std::stoi(found[4]));
    EXPECT_EQ(std::stoi(found[4]), GoldenCamera(frame).rays(0)[pixel][found[2][0] - 'x']);
  }
}

TEST(Figures, UnknownNamesAreRefusedWithTheNearest) {
  EXPECT_THAT([] { figure("hexagone"); },
              testing::ThrowsMessage<UsageError>(HasSubstr("did you mean 'hexagon'?")));
}

}  // namespace
}  // namespace racebeam
