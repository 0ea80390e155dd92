// Scene files of the sphere tracer: what their keys become, and what is refused.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/sphere_scene.h"

#include <gmock/gmock.h>

#include <string>

#include "sc/sphere/engine.h"
#include "tb/scene/starter_scene.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string Head = "engine = \"sphere\"\n";
const std::string Red =
    "[[sphere]]\nid = \"red\"\ncentre = [-9, 0, 15]\nradius = 5\ncolour = \"#ff2121\"\n";

AnySceneResult read(const std::string& text) { return read_any_scene(text, "test"); }

std::string faults_in(const std::string& text) { return read(text).faults.text("f"); }

/// Faults of a scene whose red sphere, from line 2 on, has one more line: line 7.
std::string faults_with(const std::string& more) { return faults_in(Head + Red + more + "\n"); }

SphereProgram good(const std::string& text) {
  const AnySceneResult result = read(text);
  EXPECT_TRUE(result.scene) << result.faults.text("f");
  return result.scene ? static_cast<const SphereProgram&>(result.scene->tables()) : SphereProgram();
}

TEST(SphereSceneTest, KeysBecomeTables) {
  const AnySceneResult result = read(R"(engine = "sphere"
frames = 120
[eye]
position = [1, -2.5, -32]
screen = 4.0
[light]
position = [15, -15, -1]
[modes]
size = "320x240"
reflections = 3
antialias = "8x"
[box]
low = [-10, -11, 5]
high = [10, 11, 35]
[[sphere]]
id = "red"
centre = [-9, 0.5, 15]
radius = 5
colour = "#ff2108"
reflect = 0.25
velocity = [0.5, 0.125, 0]
[[plane]]
normal = [0, -1, 0]
distance = 22.5
colour = "#e8e8e8"
reflect = 1
checker = 1
limits = [26, 30, 40]
[[input]]
picture = 30
pictures = 10
hold = ["SW15", "KEY0"]
)");
  ASSERT_TRUE(result.scene) << result.faults.text("f");
  EXPECT_EQ(&result.scene->engine(), &sphere_engine());
  EXPECT_EQ(result.scene->frames(), 120);
  EXPECT_EQ(result.scene->counts(), "1 sphere, 1 plane");
  EXPECT_EQ(result.scene->part(0), "8x, 3 reflections, planes");
  const auto& program = static_cast<const SphereProgram&>(result.scene->tables());
  EXPECT_THAT(program.start.origin, ElementsAre(4096, -10240, -131072));
  EXPECT_THAT(program.start.light, ElementsAre(61440, -61440, -4096));
  EXPECT_EQ(program.start.screen, 4 * 4096);
  EXPECT_EQ(program.board.sw, 3 << 2 | 2);
  EXPECT_EQ(program.board.key_n, 11) << "KEY2 turns the planes on";
  EXPECT_EQ(program.spheres, 1);
  ASSERT_EQ(program.moving.size(), 1U);
  EXPECT_THAT(program.moving[0].colour, ElementsAre(31, 4, 1));
  EXPECT_EQ(program.moving[0].reflect, 0x400);
  EXPECT_THAT(program.moving[0].velocity, ElementsAre(0.5, 0.125, 0));
  ASSERT_EQ(program.planes.size(), 1U);
  EXPECT_THAT(program.planes[0].normal, ElementsAre(0, -4096, 0));
  EXPECT_EQ(program.planes[0].distance, 22 * 4096 + 2048);
  EXPECT_EQ(program.planes[0].reflect, 4095) << "12 bits";
  EXPECT_EQ(program.planes[0].checker, 1);
  EXPECT_TRUE(program.planes[0].limited);
  EXPECT_THAT(program.planes[0].limit, ElementsAre(26, 30, 40));
  EXPECT_EQ(program.board_in(29).sw, program.board.sw);
  EXPECT_EQ(program.board_in(30).sw, program.board.sw | 1 << 15);
  EXPECT_EQ(program.board_in(39).key_n, 14);
  EXPECT_EQ(program.board_in(40).key_n, 15);
}

TEST(SphereSceneTest, WithoutKeysItIsTheSourcesScene) {
  const SphereProgram program = good(Head + Red);
  EXPECT_THAT(program.start.origin, ElementsAre(0, 0, -32 * 4096));
  EXPECT_THAT(program.start.light, ElementsAre(15 * 4096, 15 * 4096, -4096));
  EXPECT_EQ(program.start.screen, 8 * 4096);
  EXPECT_EQ(program.board.sw, 1 << 5);
  EXPECT_TRUE(program.planes.empty());
}

TEST(SphereSceneTest, TheStarterIsGood) {
  const AnySceneResult result = read(starter_sphere_scene());
  ASSERT_TRUE(result.scene) << result.faults.text("f");
  EXPECT_EQ(result.faults.warnings("f"), "");
}

TEST(SphereSceneTest, KEY3ResetsEyeAndLightAndTakesPlanes) {
  const SphereProgram program =
      good(Head + Red +
           "[modes]\nplanes = false\n"
           "[[input]]\nhold = [\"SW17\", \"KEY0\"]\n"
           "[[input]]\npicture = 2\nhold = [\"KEY3\", \"KEY2\", \"SW4\"]\n");
  EXPECT_THAT(program.inputs_before(1).light_q, ElementsAre(16 * 4096, 15 * 4096, -4096));
  EXPECT_EQ(program.inputs_before(1).screen_q, 8 * 4096 + 256);
  EXPECT_FALSE(program.inputs_before(1).planes_q);
  EXPECT_TRUE(program.resets(2));
  EXPECT_EQ(program.inputs_before(2).light_q, program.start.light);
  EXPECT_TRUE(program.inputs_before(2).planes_q);
  EXPECT_TRUE(program.inputs_before(3).scene_q);
  EXPECT_FALSE(program.inputs_before(0).scene_q) << "the start has the modes only";
}

TEST(SphereSceneFaults, MoreSpheresThanTheTable) {
  std::string text = Head;
  for (int n = 0; n < 16; ++n) text += "[[sphere]]\ncentre = [0, 0, 20]\nradius = 1\n";
  EXPECT_EQ(faults_in(text),
            "f:47:1: the scene has 16 spheres\n"
            "  help: at most 15: the table holds the light as well\n");
}

TEST(SphereSceneFaults, MorePlanesThanTheTable) {
  std::string text = Head + Red;
  for (int n = 0; n < 9; ++n) text += "[[plane]]\nnormal = [0, 0, -1]\ndistance = 9\n";
  EXPECT_THAT(faults_in(text), HasSubstr("the scene has 9 planes\n  help: at most 8"));
}

TEST(SphereSceneFaults, RadiusNotWholeOrOutside) {
  const std::string head = Head + "[[sphere]]\ncentre = [0, 0, 90]\nradius = ";
  EXPECT_EQ(faults_in(head + "2.5\n"),
            "f:4:10: 'radius' is a number with a point\n  help: it must be a whole number 1..63\n");
  EXPECT_EQ(faults_in(head + "0\n"), "f:4:10: 'radius' is 0\n  help: it must be in 1..63\n");
  EXPECT_EQ(faults_in(head + "64\n"), "f:4:10: 'radius' is 64\n  help: it must be in 1..63\n");
}

TEST(SphereSceneFaults, CoordinateBeyond1000) {
  EXPECT_EQ(faults_in(Head + "[[sphere]]\ncentre = [0, 1000.5, 90]\nradius = 1\n"),
            "f:3:14: 'centre' is 1000.5\n  help: it must be in -1000..1000\n");
  EXPECT_EQ(faults_with("[eye]\nposition = [0, 0, -1001]"),
            "f:8:19: 'position' is -1001\n  help: it must be in -1000..1000\n");
  EXPECT_EQ(faults_with("[light]\nposition = [0, nan, 0]"),
            "f:8:16: 'position' is not a finite number\n  help: it must be in -1000..1000\n");
}

TEST(SphereSceneFaults, NormalNotOfLengthOne) {
  EXPECT_EQ(faults_with("[[plane]]\nnormal = [0, -3, 4]\ndistance = 2"),
            "f:8:10: 'normal' is of length 5, not of 1\n"
            "  help: write [0.0000, -0.6000, 0.8000]\n");
  EXPECT_EQ(faults_with("[[plane]]\nnormal = [0, 0, 0]\ndistance = 2"),
            "f:8:10: 'normal' is of length 0, not of 1\n"
            "  help: write a direction: [0, -1, 0] is up\n");
  EXPECT_EQ(faults_with("[[plane]]\nnormal = [0, 1.015, 0]\ndistance = 2"), "");
  EXPECT_THAT(faults_with("[[plane]]\nnormal = [0, 0.98, 0]\ndistance = 2"),
              HasSubstr("'normal' is of length 0.98"));
}

TEST(SphereSceneFaults, TwoIdsAlike) {
  EXPECT_EQ(faults_with("[[sphere]]\nid = \"red\"\ncentre = [9, 0, 15]\nradius = 5"),
            "f:8:6: two spheres are called 'red'\n"
            "  help: the first is in line 3; give each a name of its own\n");
}

TEST(SphereSceneFaults, ReflectOutside) {
  EXPECT_EQ(faults_with("reflect = 1.5"), "f:7:11: 'reflect' is 1.5\n  help: it must be in 0..1\n");
  EXPECT_EQ(faults_with("reflect = -0.1"),
            "f:7:11: 'reflect' is -0.1\n  help: it must be in 0..1\n");
}

TEST(SphereSceneFaults, LightInsideASphere) {
  EXPECT_EQ(faults_with("[light]\nposition = [-9, 3, 15]"),
            "f:8:12: the light is inside the sphere in line 4\n"
            "  help: move the light or the sphere: shadows are found from outside\n");
  EXPECT_EQ(faults_in(Head + "[[sphere]]\ncentre = [15, 15, 0]\nradius = 5\n"),
            "f:3:10: the light is inside the sphere in line 3\n"
            "  help: move the light or the sphere: shadows are found from outside\n");
}

TEST(SphereSceneFaults, EyeOnTheScreen) {
  EXPECT_EQ(faults_with("[eye]\nposition = [0, 0, 256]"),
            "f:8:12: the eye is on the screen, which stands at z = 256\n"
            "  help: move it away: z is smaller in front of the screen\n");
  EXPECT_EQ(faults_with("[eye]\nscreen = -1.0"),
            "f:7:1: the eye is on the screen, which stands at z = -32\n"
            "  help: move it away: z is smaller in front of the screen\n");
}

TEST(SphereSceneFaults, UnknownSwitch) {
  EXPECT_EQ(faults_with("[[input]]\nhold = [\"SW15\", \"SW18\"]"),
            "f:8:17: there is no switch or key 'SW18'\n"
            "  help: there is SW0..SW17 and KEY0..KEY3\n");
  EXPECT_THAT(faults_with("[[input]]\nhold = \"SW1\""), HasSubstr("'hold' is a string"));
  EXPECT_THAT(faults_with("[[input]]\npicture = 3"), HasSubstr("'input' has no 'hold'"));
}

TEST(SphereSceneFaults, VelocityAbove64) {
  EXPECT_EQ(faults_with("velocity = [0, 64.5, 0]"),
            "f:7:16: 'velocity' is 64.5\n  help: it must be in -64..64\n");
}

TEST(SphereSceneFaults, UnknownKeysNameTheNearest) {
  EXPECT_EQ(faults_with("refect = 0.5"),
            "f:7:1: unknown key 'refect' in 'sphere'\n  help: did you mean 'reflect'?\n");
  EXPECT_EQ(faults_with("[[plan]]"),
            "f:7:3: unknown key 'plan' in the file\n  help: did you mean 'plane'?\n");
}

TEST(SphereSceneFaults, ASceneNeedsASphere) {
  EXPECT_THAT(faults_in(Head), HasSubstr("f:1:1: the scene has no spheres"));
  EXPECT_THAT(faults_in(Head + "sphere = 3\n"), HasSubstr("it must be tables: write [[sphere]]"));
}

TEST(SphereSceneFaults, ABoxTheWrongWayRound) {
  EXPECT_THAT(faults_with("[box]\nlow = [0, 5, 0]\nhigh = [1, 4, 1]"),
              HasSubstr("'low' is above 'high' in y"));
}

TEST(SphereSceneFaults, ASphereOutsideOfTheBoxIsAWarning) {
  const AnySceneResult result = read(Head + "[[sphere]]\ncentre = [0, 0, 90]\nradius = 5\n");
  ASSERT_TRUE(result.scene);
  EXPECT_THAT(result.faults.warnings("f"),
              HasSubstr("f:3:10: warning: the sphere stands outside of the box"));
}

}  // namespace
}  // namespace racebeam
