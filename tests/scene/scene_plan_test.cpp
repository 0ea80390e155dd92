// Floor plans: what a drawing becomes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <random>

#include "tb/scene/camera_path.h"
#include "tb/scene/plan_storeys.h"
#include "tests/support/scene_text.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string plan(const std::string& rows, const std::string& more = "") {
  return "[plan]\nstoreys = \"\"\"\n" + rows + "\"\"\"\n" + more;
}

TEST(ScenePlanTest, TheFirstRowIsNorthAndTheFirstColumnWest) {
  const SceneFile scene = good_scene(plan("..\n@#\n"));
  EXPECT_THAT(room_of(scene, "start").centre, ElementsAre(0, -256, 0));
  EXPECT_THAT(room_of(scene, "1.1.1").centre, ElementsAre(0, -256, 256));
  EXPECT_THAT(room_of(scene, "1.1.2").centre, ElementsAre(256, -256, 256));
  EXPECT_THAT(room_of(scene, "start").half_size, ElementsAre(128, 256, 128));
}

TEST(ScenePlanTest, NeighboursConnectByThemselves) {
  const SceneFile scene = good_scene(plan("..\n@#\n"));
  EXPECT_THAT(room_of(scene, "start").portals[North], ElementsAre(number_of(scene, "1.1.1")));
  EXPECT_THAT(room_of(scene, "1.1.1").portals[East], ElementsAre(number_of(scene, "1.1.2")));
  EXPECT_THAT(room_of(scene, "1.1.2").portals[South], IsEmpty());
  EXPECT_EQ(count_portals(scene), 2);
}

TEST(ScenePlanTest, KindsHaveTheirOwnHeightAndFloor) {
  const SceneFile scene =
      good_scene(plan("@a\n", "[plan.cells]\na = { height = 200, floor = 100, id = \"step\" }\n"));
  EXPECT_THAT(room_of(scene, "step").centre, ElementsAre(256, -200, 0));
  EXPECT_THAT(room_of(scene, "step").half_size, ElementsAre(128, 100, 128));
  EXPECT_EQ(count_portals(scene), 1);
  EXPECT_EQ(count_portals(good_scene(plan("@a\n", "[plan.cells]\na = { floor = 512 }\n"))), 0)
      << "floor at the ceiling of the other";
}

TEST(ScenePlanTest, KindsUsedTwiceAreNumbered) {
  const SceneFile scene = good_scene(plan("@aa\n", "[plan.cells]\na = { id = \"hall\" }\n"));
  EXPECT_EQ(number_of(scene, "hall.1"), 1);
  EXPECT_EQ(number_of(scene, "hall.2"), 2);
}

TEST(ScenePlanTest, ASkylightIsANiche) {
  const SceneFile scene = good_scene(plan("a\n", R"(slab = 40
opening = 100
[plan.cells]
a = { skylight = true, id = "start" }
)"));
  const Room& niche = room_of(scene, "start.up");
  EXPECT_THAT(niche.half_size, ElementsAre(50, 20, 50));
  EXPECT_EQ(niche.high(1), room_of(scene, "start").low(1));
  EXPECT_THAT(room_of(scene, "start").portals[Up], ElementsAre(1));
  EXPECT_THAT(niche.portals[Up], IsEmpty());
}

TEST(ScenePlanTest, AFloorHoleLeadsToTheCellBelow) {
  const std::string text = "[plan]\nstoreys = [\"@\", \"h\"]\n[plan.cells]\nh = { hole = true }\n";
  const SceneFile scene = good_scene(text);
  const int shaft = number_of(scene, "start.up");
  EXPECT_THAT(room_of(scene, "2.1.1").portals[Down], ElementsAre(shaft));
  EXPECT_THAT(scene.rooms[shaft].portals[Down], ElementsAre(0));
  const SceneFile thin = good_scene(
      "plan.slab = 0\n"
      "plan.storeys = [\"@\", \"h\"]\nplan.cells.h.hole = true\n");
  EXPECT_THAT(thin.rooms[1].portals[Down], ElementsAre(0)) << "no slab, no shaft";
}

TEST(ScenePlanTest, ATallCellMeetsBothStoreysBesideIt) {
  const SceneFile scene = good_scene(
      "[plan]\nstoreys = [\"t@\", \"#.\"]\n"
      "[plan.cells]\nt = { height = 1056, id = \"tower\" }\n");
  EXPECT_THAT(room_of(scene, "tower").portals[East], testing::SizeIs(2));
}

// The columns of contract 17.2's narrow scenes: 160 and 352 wide, 256 from centre to centre.
TEST(ScenePlanTest, WidthsAndDepthsRepeatFromTheSouthWest) {
  const SceneFile scene =
      good_scene(plan("...\n@..\n", "widths = [160, 352]\ndepths = [64, 32]\n"));
  EXPECT_THAT(room_of(scene, "start").centre, ElementsAre(0, -256, 0));
  EXPECT_THAT(room_of(scene, "start").half_size, ElementsAre(80, 256, 32));
  EXPECT_THAT(room_of(scene, "1.2.2").centre, ElementsAre(256, -256, 0));
  EXPECT_THAT(room_of(scene, "1.2.2").half_size, ElementsAre(176, 256, 32));
  EXPECT_THAT(room_of(scene, "1.1.3").centre, ElementsAre(512, -256, 48));
  EXPECT_THAT(room_of(scene, "1.1.3").half_size, ElementsAre(80, 256, 16));
  EXPECT_EQ(count_portals(scene), 7) << "the cells adjoin";
}

TEST(ScenePlanTest, WidthsLeaveTheDepthOfTheCell) {
  const SceneFile scene = good_scene(plan("@.\n", "cell = [64, 32]\nwidths = [160]\n"));
  EXPECT_THAT(room_of(scene, "1.1.2").half_size, ElementsAre(80, 256, 16));
  EXPECT_THAT(room_of(scene, "1.1.2").centre, ElementsAre(160, -256, 0));
}

// As the ceiling windows of the narrow scenes: 192 wide over cells of 160.
TEST(ScenePlanTest, AnOpeningMayBeWiderThanItsCell) {
  const SceneFile scene = good_scene(plan("@w\n", R"(widths = [160, 352]
cell = 256
opening = 192
[plan.cells]
"@" = { skylight = true }
w = { skylight = true }
)"));
  EXPECT_THAT(room_of(scene, "start.up").half_size, ElementsAre(96, 16, 96));
  EXPECT_THAT(room_of(scene, "start").portals[Up], ElementsAre(number_of(scene, "start.up")));
  EXPECT_THAT(room_of(scene, "start.up").centre, ElementsAre(0, -528, 0));
}

TEST(ScenePlanTest, PlansOfDifferentSetsStandInOneFile) {
  const SceneFile scene = good_scene(R"(camera.room = "b.start"
[[plan]]
storeys = "@."
[[plan]]
set = "b"
origin = [0, 0, 512]
storeys = "@hh."
[plan.cells]
h = { id = "hall" }
[[plan]]
set = "c"
storeys = "s."
[plan.cells]
s = { skylight = true }
)");
  const char* const ids[] = {"start",   "1.1.2",   "b.start", "hall.1",    "hall.2",
                             "b.1.1.4", "c.1.1.1", "c.1.1.2", "c.1.1.1.up"};
  ASSERT_EQ(scene.rooms.size(), 9U);
  for (int i = 0; i < 9; ++i) EXPECT_EQ(number_of(scene, ids[i]), i);
  EXPECT_EQ(room_of(scene, "c.1.1.1.up").set, "c");
  EXPECT_EQ(scene.shots[0].camera.room, 2);
}

TEST(ScenePlanTest, NeighboursLeadBackAndTouchWhateverIsDrawn) {
  std::mt19937 random(2);
  for (int run = 0; run < 200; ++run) {
    const int columns = 1 + random() % 9, rows = 1 + random() % 9, storeys = 1 + random() % 3;
    std::string text = "plan.slab = " + std::to_string(random() % 3 * 16) + "\nplan.storeys = [";
    for (int s = 0; s < storeys; ++s) {
      text += "\"\"\"\n";
      for (int r = 0; r < rows; ++r) {
        for (int c = 0; c < columns; ++c) text += s + r + c == 0 ? '@' : "#...abcd"[random() % 8];
        text += "\n";
      }
      text += "\"\"\",";
    }
    const SceneFile scene = good_scene(text + R"(]
[plan.cells]
a = { skylight = true, hole = true }
b = { height = 256 }
c = { height = 128, floor = 64, hole = true }
d = { floor = 200, height = 300, skylight = true }
)");
    ASSERT_FALSE(scene.rooms.empty());
    for (std::size_t i = 0; i < scene.rooms.size(); ++i)
      for (int face = 0; face < FaceCount; ++face)
        for (const int next : scene.rooms[i].portals[face]) {
          EXPECT_TRUE(rooms_touch(scene.rooms[i], face, scene.rooms[next])) << text;
          EXPECT_THAT(scene.rooms[next].portals[opposite(face)],
                      testing::Contains(static_cast<int>(i)))
              << text;
        }
  }
}

TEST(ScenePlanTest, BadPlansAreRefusedWithTheirPlace) {
  const auto expect = [](const std::string& text, const std::string& fault) {
    EXPECT_THAT(faults_of(text), HasSubstr(fault)) << text;
  };
  expect(plan("@..\n..\n...\n"), "f:4:1: this row has 2 cells, the first one 3");
  expect(plan(""), "f:2:11: the plan is empty");
  expect(plan("###\n###\n"), "f:2:11: the plan is empty");
  expect("[plan]\nstoreys = []\n", "f:2:11: the plan is empty");
  expect("[plan]\n", "f:1:1: 'plan' has no 'storeys'");
  expect("[plan]\nstoreys = [\"@\", 3]\n", "f:2:17: a storey is a whole number");
  expect("[plan]\nstoreys = [\"@\", \"..\"]\n", "f:2:18: this storey is 2 x 1 cells");
  expect(plan("#@#\n#x#\n"), "f:4:2: 'x' is no kind of cell");
  expect("[plan]\nstoreys = [\"@..\", \"..x\"]\n", "f:2:22: 'x' is no kind of cell");
  expect("[plan]\nstoreys = '''@.\nx.'''\n", "f:3:1: 'x' is no kind of cell");
  expect(plan("@\n", "cell = 255\n"), "f:5:8: 'cell' is odd");
  expect(plan("@\n", "cell = [2]\n"), "f:5:8: 'cell' has not two numbers");
  expect(plan("@\n", "opening = 258\n"), "f:5:11: 'opening' is too large for the cells");
  expect(plan("@.\n", "widths = [160, 352]\nopening = 258\n"), "f:6:11: 'opening' is too large");
  expect(plan("@\n", "widths = 160\n"), "f:5:10: 'widths' is no list of numbers");
  expect(plan("@\n", "depths = []\n"), "f:5:10: 'depths' is no list of numbers");
  expect(plan("@.\n", "widths = [160, 351]\n"), "f:5:16: 'widths' is odd");
  expect(plan("@\n", "depths = [\"2\"]\n"), "f:5:11: 'depths' is a string");
  expect(plan("@\n", "depths = [0]\n"), "f:5:11: 'depths' is 0");
  expect(plan("@.\n", "widths = [2, 4, 6]\n"), "f:5:10: 'widths' has 3 numbers for 2 columns");
  expect(plan("@.\n", "depths = [2, 4]\n"), "f:5:10: 'depths' has 2 numbers for 1 rows");
  expect("plan = []\n", "f:1:1: the scene has no rooms");
  expect("plan = [3]\n", "f:1:9: 'plan' is a whole number");
  expect("plan.storeys = \"@" + std::string(8191, '#') + "\"\n",
         "f:1:16: the plan is 8192 cells long");
  expect("plan = [{ storeys = \"@\" }, { storeys = \"@\" }]\n",
         "f:1:28: two plans have the set ''");
  expect("[[plan]]\nset = \"a\"\nstoreys = \"@\"\n[[plan]]\nset = \"a\"\nstoreys = \"@\"\n",
         "f:5:7: two plans have the set 'a'");
  expect("[[plan]]\nset = \"a\"\nstoreys = \"@\"\n", "f:1:1: the camera has no room");
  expect(plan("@\n", "[plan.cells]\nab = {}\n"), "f:6:1: 'ab' cannot be a kind of cell");
  expect(plan("@\n", "[plan.cells]\n\"#\" = {}\n"), "f:6:1: '#' cannot be a kind of cell");
  expect(plan("@\n", "[plan.cells]\na = { hieght = 2 }\n"), "f:6:7: unknown key 'hieght'");
  expect("[plan]\nstoreys = [\"@\", \".\"]\n[plan.cells]\n\"@\" = { height = 600 }\n",
         "f:2:18: rooms 'start' and '2.1.1' overlap");
}

// Two storeys with a step up to the second, a shaft between them, and a set of its own.
const std::string House = R"(frames = 400
[camera]
velocity = [2, 0, 0]
[[plan]]
height = 200
slab = 56
storeys = ["@s", "h#"]
[plan.cells]
s = { floor = 100 }
h = { hole = true }
[[plan]]
set = "b"
origin = [0, 0, 4096]
storeys = "@"
[[shot]]
frame = 100
camera = { room = "b.start", velocity = [0, 0, 0] }
[[shot]]
frame = 300
camera = { room = "2.1.1" }
)";

TEST(ScenePlanTest, StoreysHoldRoomsBesideEachOtherAndTheShaftsOverThem) {
  const SceneFile scene = good_scene(House);
  const std::vector<Storey> storeys = storeys_of(scene);
  ASSERT_EQ(storeys.size(), 3U);
  EXPECT_THAT(storeys[0].rooms, ElementsAre(number_of(scene, "start"), number_of(scene, "1.1.2")));
  EXPECT_THAT(storeys[0].shafts, ElementsAre(number_of(scene, "start.up")));
  EXPECT_THAT(storeys[1].rooms, ElementsAre(number_of(scene, "2.1.1")));
  EXPECT_EQ(storeys[1].number, 2);
  EXPECT_EQ(storeys[2].set, "b");
  EXPECT_EQ(storeys[2].number, 1);
}

TEST(ScenePlanTest, StrandsEndWhereAShotSetsTheCameraDown) {
  const SceneFile scene = good_scene(House);
  const std::vector<Strand> strands = strands_of(scene, fly(scene), storeys_of(scene));
  ASSERT_EQ(strands.size(), 3U);
  for (const Strand& strand : strands) EXPECT_TRUE(strand.jumps);
  EXPECT_EQ(strands[0].points.size(), 100U);
  EXPECT_EQ(strands[0].points.back().frame, 99);
  EXPECT_EQ(strands[0].points.back().place[0], 2 * 98) << "the second frame shows the same place";
  EXPECT_EQ(strands[1].storey, 2);
  EXPECT_EQ(strands[1].points.front().frame, 100);
  EXPECT_EQ(strands[2].storey, 1);
}

TEST(ScenePlanTest, AStrandGoesOnInTheNextStoreyWhereItWas) {
  const SceneFile scene = good_scene(R"(frames = 300
camera.velocity = [0, -2, 0]
[plan]
height = 200
slab = 56
storeys = ["@", "h"]
[plan.cells]
h = { hole = true, height = 600 }
)");
  const std::vector<Strand> strands = strands_of(scene, fly(scene), storeys_of(scene));
  ASSERT_EQ(strands.size(), 2U);
  EXPECT_EQ(strands[0].storey, 0);
  EXPECT_EQ(strands[1].storey, 1);
  EXPECT_FALSE(strands[1].jumps);
  EXPECT_EQ(strands[1].points[0].frame, strands[0].points.back().frame);
  EXPECT_EQ(strands[1].points[1].place[1], strands[0].points.back().place[1] - 2);
}

}  // namespace
}  // namespace racebeam
