// The camera and the look of scene files, as the golden tracers show them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <set>

#include "tests/golden/golden_scene_bench.h"

namespace racebeam {
namespace {

using Tracer = GoldenTracer;

GoldenCamera camera_of(const std::string& turns, int frame = 0) {
  return {
      good_scene("[camera]\nroom = \"hall\"\n" + turns + room("hall", "0, 0, 0", "256, 128, 256")),
      frame};
}

TEST(SceneCamera, TurnsMoveByFrameAndByLine) {
  const GoldenCamera camera = camera_of(R"(yaw = { start = 100, step = 3, every = 2, per_line = 1 }
pitch = { start = -1, step = -2 }
fov = { start = 250, per_line = 1 }
)",
                                        5);
  const GoldenView view = camera.view(-7);
  EXPECT_EQ(view.yaw, 100 + 3 * 2 - 7);
  EXPECT_EQ(view.pitch, 2048 - 1 - 10);
  EXPECT_EQ(view.fov, 243);
  EXPECT_EQ(camera.view(10).fov, 4) << "modulo 256";
}

// Contract 7.1: ddr is (cos, 0, -sin) of yaw. Sine is frac + frac * inv / 512 with inv = 511 -
// frac, rounded half up: 1 + 510 / 512 = 2 and 2 + 1018 / 512 = 4. Cosine is inv + the same
// product.
TEST(SceneCamera, OddAnglesLieBetweenEvenOnes) {
  const auto ddr = [](int yaw) {
    return golden_line(camera_of("yaw = " + std::to_string(yaw) + "\n").view(0), 0).ddr;
  };
  EXPECT_EQ(ddr(0), (vec3{511, 0, 0}));
  EXPECT_EQ(ddr(1), (vec3{511, 0, -2}));
  EXPECT_EQ(ddr(2), (vec3{511, 0, -4}));
  EXPECT_EQ(ddr(513), (vec3{-2, 0, -511})) << "a quarter turn on";
  const GoldenIdeal ideal = camera_of("yaw = 1\n").ideal(0);
  EXPECT_NEAR(ideal.ddr[2], -(1 / 512.0) * (2 - 1 / 512.0), 1e-12);
}

std::string box(const std::string& camera, const std::string& look = "") {
  return "[camera]\nroom = \"hall\"\n" + camera + look +
         room("hall", "0, 0, 0", "256, 128, 256", "north = \"next\"") +
         room("next", "0, 0, 512", "64, 64, 256");
}

TEST(SceneCamera, OddAnglesGiveAnotherPictureThanEvenOnes) {
  const auto picture = [](Tracer tracer, const std::string& turn) {
    return GoldenScene(box(turn)).picture(tracer, 0);
  };
  for (const Tracer tracer : GoldenTracers)
    for (const std::string angle : {"yaw = ", "pitch = "}) {
      const GoldenPicture odd = picture(tracer, angle + "101\n");
      EXPECT_NE(odd, picture(tracer, angle + "100\n")) << angle;
      EXPECT_NE(odd, picture(tracer, angle + "102\n")) << angle;
    }
}

GoldenPicture row(const GoldenPicture& picture, int y) {
  const auto begin = picture.begin() + (y + 240) * VisibleColumns;
  return {begin, begin + VisibleColumns};
}

TEST(SceneCamera, ATwistTurnsEachLineByItself) {
  const GoldenScene twisted(box("yaw = { start = 100, per_line = 3 }\n"));
  for (const int y : {-240, -33, 0, 239}) {
    const GoldenScene plain(box("yaw = " + std::to_string(100 + 3 * y) + "\n"));
    for (const Tracer tracer : GoldenTracers)
      EXPECT_EQ(row(twisted.picture(tracer, 0), y), row(plain.picture(tracer, 0), y)) << y;
  }
}

TEST(SceneCamera, InterlacedOddLinesShowZOneUnitBack) {
  GoldenScene both(box("position = [40, 10, 9]\ninterlace = true\n"));
  const GoldenScene here(box("position = [40, 10, 9]\n")), back(box("position = [40, 10, 8]\n"));
  for (const Tracer tracer : GoldenTracers) {
    const GoldenPicture picture = both.picture(tracer, 0);
    const GoldenPicture even = here.picture(tracer, 0), odd = back.picture(tracer, 0);
    ASSERT_NE(even, odd);
    for (int y = -240; y < 240; ++y) ASSERT_EQ(row(picture, y), row(y & 1 ? odd : even, y)) << y;
  }
  both.k.interlace = 0;
  EXPECT_EQ(both.picture(Tracer::Trace2, 0), here.picture(Tracer::Trace2, 0));
}

// Around the camera, focal length 168: pixels 20 and 620 hit the west and the east wall, lines -100
// and 100 in the middle the ceiling and the floor; the middle is the room next door, to its sides
// the north wall.
constexpr Palette Colours = {0b000001, 0b001000, 0b110000, 0b011011};
constexpr Palette PatternColours = {0b010000, 0b100100, 0b111000, 0b111111};
std::string look(const std::string& more) {
  return box("fov = 168\n",
             "[look]\npalette = [\"001\", \"020\", \"300\", \"123\"]\n"
             "pattern_palette = [\"100\", \"210\", \"320\", \"333\"]\n" +
                 more);
}

/// The colour index in `palette` that a column of a line has; -1: none, -2: tracers disagree.
int index_at(const GoldenScene& shown, int column, int y, const Palette& palette = Colours) {
  std::set<int> indices;
  for (const Tracer tracer : GoldenTracers) {
    const auto at =
        std::find(palette.begin(), palette.end(), row(shown.picture(tracer, 0), y)[column]);
    indices.insert(at == palette.end() ? -1 : static_cast<int>(at - palette.begin()));
  }
  return indices.size() == 1 ? *indices.begin() : -2;
}

TEST(SceneLook, WallsAreShadedByAxisInTheScenesColours) {
  const GoldenScene plain(look("")), inverse(look("inverse = true\n"));
  EXPECT_EQ(index_at(plain, 21, 0), 3) << "x";
  EXPECT_EQ(index_at(plain, 321, 100), 2) << "y";
  EXPECT_EQ(index_at(plain, 391, 0), 1) << "z";
  EXPECT_EQ(index_at(plain, 0, 0), 0) << "column 0";
  EXPECT_EQ(index_at(inverse, 21, 0), 2);
  EXPECT_EQ(index_at(inverse, 321, 100), 3);
  EXPECT_EQ(index_at(inverse, 391, 0), 1);
}

TEST(SceneLook, DitheredWallsAlternateBetweenLines) {
  GoldenScene shown(look("shading = \"dithered\"\n"));
  const struct {
    int column, y, even, odd;  // contract 15.1
  } walls[] = {{621, 0, 0, 1}, {21, 0, 3, 3}, {321, 100, 1, 1}, {321, -100, 2, 3}, {391, 0, 1, 2}};
  for (const auto& wall : walls) {
    EXPECT_EQ(index_at(shown, wall.column, wall.y), wall.even) << wall.column << " " << wall.y;
    EXPECT_EQ(index_at(shown, wall.column, wall.y + 1), wall.odd) << wall.column << " " << wall.y;
  }
  shown.k.dithering = 0;
  EXPECT_EQ(index_at(shown, 391, 1), 1);
}

// Contract 17.4: (dr_x[6:5] | dr_z[5:4]) & dr_y[7:6]; dr is (p - 320, y, 168): z gives 2; x 1 at
// pixel 365 and 0 at 330; y 0 at 30, 1 at 100, 2 at 150, 3 at 200.
TEST(SceneLook, ThePatternHasItsOwnColoursAndNoDelay) {
  const GoldenScene full(look("pattern = \"full\"\n"));
  const GoldenScene inverse(look("pattern = \"full\"\ninverse = true\n"));
  const auto at = [](const GoldenScene& shown, int column, int y) {
    return index_at(shown, column, y, PatternColours);
  };
  EXPECT_EQ(at(full, 365, 30), 0);
  EXPECT_EQ(at(full, 365, 100), 1);
  EXPECT_EQ(at(full, 330, 100), 0);
  EXPECT_EQ(at(full, 365, 150), 2);
  EXPECT_EQ(at(full, 365, 200), 3);
  EXPECT_EQ(at(full, 330, 200), 2);
  EXPECT_EQ(at(inverse, 365, 200), 2);
  EXPECT_EQ(at(inverse, 365, 150), 3);
}

TEST(SceneLook, APartialPatternLeavesTheRoomsWhereTheRayIsLevel) {
  const GoldenScene shown(look("pattern = \"partial\"\n"));
  EXPECT_EQ(index_at(shown, 365, 200, PatternColours), 3);
  EXPECT_EQ(index_at(shown, 391, 30), 1) << "the north wall";
  EXPECT_EQ(index_at(shown, 21, 30), 3) << "the west wall";
}

}  // namespace
}  // namespace racebeam
