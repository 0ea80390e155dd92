// Scene files of the block renderer: what their keys become, and what is refused.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/block_scene.h"

#include <gmock/gmock.h>

#include <string>

#include "sc/block/engine.h"
#include "tb/host/sphere_program.h"
#include "tb/scene/starter_scene.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::FloatEq;
using testing::HasSubstr;

const std::string Head = "engine = \"block\"\n";
const std::string Red =
    "[[sphere]]\nid = \"red\"\ncentre = [-2, -1, 2]\nradius = 0.75\ncolour = \"#ff2100\"\n";

AnySceneResult read(const std::string& text) { return read_any_scene(text, "test"); }

std::string faults_in(const std::string& text) { return read(text).faults.text("f"); }

/// Faults of a scene whose red sphere, from line 2 on, has one more line: line 7.
std::string faults_with(const std::string& more) { return faults_in(Head + Red + more + "\n"); }

/// Faults of a scene of one sphere, in line 2.
std::string faults_of(const std::string& centre, const std::string& radius,
                      const std::string& more = "") {
  return faults_in(Head + "[[sphere]]\ncentre = " + centre + "\nradius = " + radius + "\n" + more);
}

BlockProgram good(const std::string& text) {
  const AnySceneResult result = read(text);
  EXPECT_TRUE(result.scene) << result.faults.text("f");
  EXPECT_EQ(result.faults.warnings("f"), "");
  return result.scene ? static_cast<const BlockProgram&>(result.scene->tables()) : BlockProgram();
}

TEST(BlockSceneTest, KeysBecomeTablesInTheRenderersUnits) {
  const AnySceneResult result = read(R"(engine = "block"
frames = 60
scale = 0.125
[eye]
position = [1, -2, -48]
[screen]
size = [64, 48]
z = 8
[light]
position = [-64, -72, -64]
[box]
low = [-32, -16, 8]
high = [32, 24, 72]
[[sphere]]
id = "red"
centre = [-16, -8, 24]
radius = 6
colour = [0.75, 0.25, 0.5]
velocity = [0.5, 0.25, -1]
[[sphere]]
centre = [16, 8, 48]
radius = 5
colour = "#ff0033"
)");
  ASSERT_TRUE(result.scene) << result.faults.text("f");
  EXPECT_EQ(&result.scene->engine(), &block_engine());
  EXPECT_EQ(result.scene->frames(), 60);
  EXPECT_EQ(result.scene->counts(), "2 spheres");
  const auto& program = static_cast<const BlockProgram&>(result.scene->tables());
  EXPECT_THAT(program.eye, ElementsAre(0.125f, 0.25f, -7.0f));
  EXPECT_THAT(program.light, ElementsAre(-8.0f, 9.0f, -9.0f));
  EXPECT_THAT(program.screen, ElementsAre(8.0f, 6.0f));
  EXPECT_THAT(program.box.low, ElementsAre(-4, -3, 0));
  EXPECT_THAT(program.box.high, ElementsAre(4, 2, 8));
  ASSERT_EQ(program.balls.size(), 2U);
  EXPECT_THAT(program.balls[0].centre, ElementsAre(-2.0f, 1.0f, 2.0f));
  EXPECT_EQ(program.balls[0].radius, 0.75f);
  EXPECT_THAT(program.balls[0].colour, ElementsAre(0.75f, 0.25f, 0.5f));
  EXPECT_THAT(program.bodies[0].velocity, ElementsAre(0.0625, -0.03125, -0.125));
  EXPECT_THAT(program.balls[1].colour, ElementsAre(1.0f, 0.0f, FloatEq(0.2f)));
}

TEST(BlockSceneTest, WithoutKeysItIsTheSourcesScene) {
  const BlockProgram program = good(Head + Red + "velocity = [0.1, 0, 0]\n");
  EXPECT_EQ(program.eye, block_tables().eye);
  EXPECT_EQ(program.light, block_tables().light);
  EXPECT_EQ(program.screen, block_tables().screen);
  EXPECT_EQ(program.box.low, BlockProgram().box.low);
  EXPECT_EQ(program.box.high, BlockProgram().box.high);
}

TEST(BlockSceneTest, TheStarterIsGood) { good(starter_block_scene()); }

TEST(BlockSceneTest, EyeLightAndSpheresAreThoseOfAFileForTheSphereTracer) {
  const std::string common = R"([eye]
position = [0, 4, -32]
[light]
position = [-32, -40, -16]
[box]
low = [-16, -16, 16]
high = [16, 16, 48]
[[sphere]]
id = "red"
centre = [-8, 2, 24]
radius = 5
colour = "#ff2121"
velocity = [0.5, 0.125, 0]
)";
  const BlockProgram block = good(Head + "scale = 0.125\n" + common);
  const AnySceneResult sphere = read("engine = \"sphere\"\n" + common);
  ASSERT_TRUE(sphere.scene) << sphere.faults.text("f");
  const auto& there = static_cast<const SphereProgram&>(sphere.scene->tables());
  const double s = 0.125, one = 4096;
  for (const std::size_t k : {0, 1, 2}) {
    const double sign = k == 1 ? -s : s;
    EXPECT_EQ(block.eye[k], sign * there.start.origin[k] / one);
    EXPECT_EQ(block.light[k], sign * there.start.light[k] / one);
    EXPECT_EQ(block.bodies[0].centre[k], sign * there.moving[0].centre[k]);
    EXPECT_EQ(block.bodies[0].velocity[k], sign * there.moving[0].velocity[k]);
  }
  EXPECT_EQ(block.bodies[0].radius, s * there.moving[0].radius);
}

TEST(BlockSceneFaults, MoreSpheresThanACoreHolds) {
  std::string text = Head;
  for (int n = 0; n < 65; ++n) text += "[[sphere]]\ncentre = [0, 0, 5]\nradius = 1\n";
  EXPECT_EQ(faults_in(text),
            "f:194:1: the scene has 65 spheres\n"
            "  help: at most 64: the cores hold no more\n");
}

TEST(BlockSceneFaults, RadiusOf2828OrMoreOrBelowA64th) {
  EXPECT_EQ(faults_of("[0, 0, 6]", "2.83"),
            "f:4:10: 'radius' is 2.83, scaled\n"
            "  help: 1/64 and more and below 2.828: the root is of numbers below 8\n");
  EXPECT_THAT(faults_of("[0, 0, 6]", "0.015"), HasSubstr("f:4:10: 'radius' is 0.015, scaled"));
  EXPECT_EQ(faults_of("[0, 0, 6]", "2.828"), "");
  EXPECT_EQ(faults_of("[0, 0, 6]", "0.015625"), "");
  EXPECT_THAT(faults_in("scale = 0.5\n" + Head + "[eye]\nposition = [0, 0, -7]\n" +
                        "[[sphere]]\ncentre = [0, 0, 6]\nradius = 6\n"),
              HasSubstr("f:7:10: 'radius' is 3, scaled"));
}

TEST(BlockSceneFaults, LightFartherThan32FromAPlaceOfASphere) {
  EXPECT_EQ(faults_with("[light]\nposition = [-2, -1, 34]"),
            "f:8:12: from the light to the sphere in line 4 it is up to 32.75, scaled\n"
            "  help: below 32; make scale, the box or the distance smaller\n");
  EXPECT_EQ(faults_with("[light]\nposition = [-2, -1, 33]"), "");
  EXPECT_THAT(faults_with("velocity = [0, 0, 0.1]\n[light]\nposition = [-2, -1, 33]"),
              HasSubstr("f:9:12: from the light to the sphere in line 4 it is up to 35.23, scaled"))
      << "it moves in the box";
}

TEST(BlockSceneFaults, EyeFartherThan32FromACornerOfTheScreen) {
  EXPECT_EQ(faults_with("[screen]\nsize = [50, 40]"),
            "f:8:8: from the eye to a corner of the screen it is 32.77, scaled\n"
            "  help: below 32; make scale, the screen or the distance smaller\n");
  EXPECT_THAT(faults_with("[eye]\nposition = [0, 0, -32]"),
              HasSubstr("f:8:12: from the eye to a corner of the screen it is 32.39, scaled"));
  EXPECT_EQ(faults_with("[screen]\nsize = [48, 39]"), "");
}

TEST(BlockSceneFaults, CoordinateOf256OrMore) {
  EXPECT_EQ(faults_of("[0, 256, 6]", "1"),
            "f:3:10: the sphere has a coordinate of -256, scaled\n"
            "  help: below 256 after scaling; make scale or the coordinate smaller\n");
  EXPECT_THAT(faults_with("[light]\nposition = [0, 0, -300]"),
              HasSubstr("f:8:12: the light has a coordinate of -300, scaled"));
  EXPECT_THAT(faults_with("[eye]\nposition = [0, 0, -260]"),
              HasSubstr("f:8:12: the eye has a coordinate of -260, scaled"));
  EXPECT_EQ(faults_of("[0, 1000.5, 6]", "1"),
            "f:3:14: 'centre' is 1000.5\n  help: it must be in -1000..1000\n");
}

// Squares of such ways would not be 12.20.
TEST(BlockSceneFaults, SphereFartherThan45FromTheEyeOrAnother) {
  const std::string box = "[box]\nhigh = [6, 5, 60]\n", light = "[light]\nposition = [0, 0, 25]\n";
  EXPECT_EQ(faults_of("[0, 0, 38.5]", "1", light + box),
            "f:3:10: from the eye to the sphere it is up to 45.5, scaled\n"
            "  help: below 45.25; make scale, the box or the distance smaller\n");
  EXPECT_EQ(faults_of("[0, 0, 38]", "1", light + box), "");
  const std::string other = "[[sphere]]\ncentre = [0, 0, 38]\nradius = 1\n";
  const std::string before = "[box]\nlow = [-6, -5, -30]\nhigh = [6, 5, 60]\n";
  EXPECT_EQ(faults_of("[0, 4, -6.5]", "0.5", other + "[light]\nposition = [0, 0, 16]\n" + before),
            "f:6:10: to the sphere in line 3 it is up to 45.68, scaled\n"
            "  help: below 45.25; make scale, the box or the distance smaller\n");
}

TEST(BlockSceneFaults, EyeOnTheScreen) {
  EXPECT_EQ(faults_with("[eye]\nposition = [0, 0, 0]"),
            "f:8:12: the eye is on the screen\n"
            "  help: move it away: z is smaller in front of it\n");
  EXPECT_THAT(faults_with("[eye]\nposition = [0, 0, 0.00003]"),
              HasSubstr("the eye is on the screen"))
      << "less than the renderer's numbers hold";
  EXPECT_THAT(faults_with("[screen]\nz = -7"), HasSubstr("f:1:1: the eye is on the screen"));
}

TEST(BlockSceneFaults, EyeInsideASphere) {
  EXPECT_EQ(faults_of("[0, 0.5, -7]", "0.75"),
            "f:3:10: the eye is inside the sphere\n"
            "  help: move one of them: what is hit from inside is not seen\n");
}

TEST(BlockSceneFaults, AMovingSphereThatCanComeAroundTheEyeIsAWarning) {
  const AnySceneResult result =
      read(Head + Red + "velocity = [0, 0, 0.1]\n[box]\nlow = [-6, -5, -7]\nhigh = [6, 5, 9]\n");
  ASSERT_TRUE(result.scene) << result.faults.text("f");
  EXPECT_THAT(result.faults.warnings("f"),
              HasSubstr("f:4:10: warning: the sphere can come around the eye"));
}

TEST(BlockSceneFaults, ScaleThatIsNoPowerOfTwo) {
  const auto scaled = [](const std::string& scale) {
    return faults_in(Head + "scale = " + scale + "\n" + Red);
  };
  EXPECT_EQ(scaled("0.3"),
            "f:2:9: 'scale' is 0.3, no power of two\n"
            "  help: write 1, 0.5, 0.25, 0.125, 0.0625, 0.03125 or 0.015625\n");
  EXPECT_THAT(scaled("2"), HasSubstr("'scale' is 2\n  help: it must be in 0.015625..1"));
  EXPECT_THAT(scaled("0.0078125"), HasSubstr("it must be in 0.015625..1"));
  EXPECT_THAT(scaled("\"1/8\""), HasSubstr("'scale' is a string"));
}

TEST(BlockSceneFaults, SizesAndColours) {
  EXPECT_THAT(faults_with("[screen]\nsize = [8]"), HasSubstr("it must be two numbers: [8, 6]"));
  EXPECT_THAT(faults_with("[screen]\nsize = [8, 0]"), HasSubstr("f:8:12: 'size' is 0"));
  const auto colour = [](const std::string& is) {
    return faults_of("[0, 0, 6]", "1", "colour = " + is + "\n");
  };
  EXPECT_THAT(colour("[0.5, 1.5, 0]"), HasSubstr("'colour' is 1.5\n  help: it must be in 0..1"));
  EXPECT_THAT(colour("\"red\""), HasSubstr("f:5:10: "));
  EXPECT_THAT(colour("3"), HasSubstr("'colour' is a whole number"));
}

TEST(BlockSceneFaults, WhatASphereNeeds) {
  EXPECT_THAT(faults_in(Head + "[[sphere]]\nradius = 1\n"), HasSubstr("'sphere' has no 'centre'"));
  EXPECT_THAT(faults_in(Head + "[[sphere]]\ncentre = [0, 0, 5]\n"),
              HasSubstr("'sphere' has no 'radius'"));
  EXPECT_THAT(faults_in(Head), HasSubstr("f:1:1: the scene has no spheres"));
  EXPECT_THAT(faults_in(Head + Red + Red), HasSubstr("f:8:6: two spheres are called 'red'"));
}

TEST(BlockSceneFaults, UnknownKeysNameTheNearest) {
  EXPECT_EQ(faults_with("velocty = [0, 0, 1]"),
            "f:7:1: unknown key 'velocty' in 'sphere'\n  help: did you mean 'velocity'?\n");
}

}  // namespace
}  // namespace racebeam
