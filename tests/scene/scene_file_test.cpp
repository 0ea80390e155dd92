// Scene files: rooms, portals, and the keys that the reader takes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <set>

#include "tb/scene/scene_keys.h"
#include "tb/scene/starter_scene.h"
#include "tests/support/room_scenes.h"
#include "tests/support/scene_text.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(SceneFileTest, RoomsAreTakenAsWritten) {
  const SceneFile scene = good_scene(TwoRooms);
  ASSERT_EQ(scene.rooms.size(), 2U);
  EXPECT_EQ(scene.rooms[1].id, "b");
  EXPECT_THAT(scene.rooms[1].centre, ElementsAre(0, 0, 256));
  EXPECT_THAT(scene.rooms[1].half_size, ElementsAre(128, 256, 128));
  EXPECT_EQ(scene.rooms[1].place.line, 9);
  EXPECT_EQ(scene.name, "test");
}

TEST(SceneFileTest, APortalNamedOnceLeadsBothWays) {
  const SceneFile scene = good_scene(TwoRooms);
  EXPECT_THAT(scene.rooms[0].portals[North], ElementsAre(1));
  EXPECT_THAT(scene.rooms[1].portals[South], ElementsAre(0));
  EXPECT_EQ(count_portals(scene), 1);
}

TEST(SceneFileTest, APortalNamedTwiceIsOnePortal) {
  const SceneFile scene = good_scene(TwoRooms + "portals = { south = \"a\" }\n");
  EXPECT_EQ(count_portals(scene), 1);
}

TEST(SceneFileTest, AFaceHoldsUpToFourPortals) {
  std::string text = R"([camera]
room = "hall"
[[room]]
id = "hall"
centre = [0, 0, 0]
half_size = [400, 100, 100]
portals = { north = ["n0", "n1", "n2", "n3"] }
)";
  for (int i = 0; i < 4; ++i)
    text += "[[room]]\nid = \"n" + std::to_string(i) + "\"\ncentre = [" +
            std::to_string(-300 + 200 * i) + ", 0, 150]\nhalf_size = [50, 50, 50]\n";
  const SceneFile scene = good_scene(text);
  EXPECT_THAT(scene.rooms[0].portals[North], ElementsAre(1, 2, 3, 4));
  const std::string five =
      text.substr(0, text.find(", \"n3\"")) + ", \"n3\", \"n4\"" + text.substr(text.find("] }"));
  EXPECT_THAT(faults_of(five), HasSubstr("f:7:21: 'north' has more than four portals"));
}

TEST(SceneFileTest, RoomsOfDifferentSetsMayStandInOnePlace) {
  const std::string twice = TwoRooms + R"([[room]]
id = "c"
centre = [0, 0, 0]
half_size = [128, 256, 128]
)";
  EXPECT_THAT(faults_of(twice), HasSubstr("rooms 'a' and 'c' overlap"));
  EXPECT_EQ(good_scene(twice + "set = \"other\"\n").rooms[2].set, "other");
  EXPECT_THAT(faults_of(twice + "set = \"other\"\nportals = { up = \"a\" }\n"),
              HasSubstr("f:17:18: rooms 'c' and 'a' are of different sets"));
}

TEST(SceneFileTest, OverlapAllowsImpossibleWorlds) {
  const std::string text = TwoRooms + "portals = { north = \"a\", east = \"b\" }\n";
  EXPECT_THAT(faults_of(text), HasSubstr("f:12:21: the north face of 'b' does not touch 'a'"));
  const SceneFile scene = good_scene("overlap = true\n" + text);
  EXPECT_THAT(scene.rooms[1].portals[East], ElementsAre(1));
  EXPECT_THAT(scene.rooms[0].portals[South], ElementsAre(1));
}

TEST(SceneFileTest, TheStarterSceneIsGoodAndShowsSomething) {
  const SceneFile scene = good_scene(starter_scene());
  EXPECT_GT(scene.rooms.size(), 10U);
  EXPECT_GT(scene.shots.size(), 1U);
}

TEST(SceneFileTest, TheScenesOfTheProjectAreGood) {
  for (const std::string& name : room_scenes()) {
    EXPECT_GE(room_scene(name).frames, 600) << "ten seconds: " << name;
  }
  EXPECT_GE(room_scenes().size(), 10U);
}

TEST(SceneFileTest, EveryKeyIsDocumentedOnceAndRead) {
  std::set<std::string> rows;
  for (const FileKey& key : scene_keys()) {
    EXPECT_TRUE(rows.insert(std::string(key.table) + "." + key.key).second) << key.key;
    EXPECT_NE(*key.meaning, 0) << key.key;
  }
  // A date is of no key's type: each key must object.
  const auto objects = [](const std::string& text, const std::string& key) {
    EXPECT_THAT(faults_of(text), HasSubstr("'" + key + "'")) << text;
  };
  const std::string date = " = 2001-01-01\n", plan = "[plan]\nstoreys = \"@\"\n";
  for (const std::string& key : keys_of("")) objects(key + date, key);
  for (const std::string& key : keys_of("room")) objects("[[room]]\n" + key + date, key);
  for (const std::string& key : keys_of("shot"))
    objects(plan + "[[shot]]\n" + (key == "frame" ? "" : "frame = 9\n") + key + date, key);
  for (const std::string& key : keys_of("camera")) objects(plan + "[camera]\n" + key + date, key);
  for (const std::string& key : keys_of("look")) objects(plan + "[look]\n" + key + date, key);
  for (const std::string& key : keys_of("cells"))
    objects(plan + "[plan.cells.a]\n" + key + date, key);
  for (const std::string& key : keys_of("turn")) objects(plan + "[camera.yaw]\n" + key + date, key);
  for (const std::string& key : keys_of("portals"))
    objects("[[room]]\n[room.portals]\n" + key + date, key);
  for (const std::string& key : keys_of("plan"))
    if (key != "storeys") objects(plan + key + date, key);
  EXPECT_THAT(faults_of("[plan]\nstoreys = 2001-01-01\n"), HasSubstr("a storey is a date"));
}

TEST(SceneFileTest, FilesThatCannotBeReadSayWhy) {
  ScratchFolder folder;
  const auto faults = [](const std::string& path) {
    return read_scene_file(path).faults.text("f");
  };
  EXPECT_THAT(faults(folder / "none.toml"), HasSubstr("f: cannot be read: No such file"));
  EXPECT_THAT(faults(folder.path()), HasSubstr("f: this is a folder"));
  EXPECT_THAT(faults("/dev/zero"), HasSubstr("f: the file is larger than 16 MB"));
  EXPECT_THAT(faults("/dev/null"), HasSubstr("f:1:1: the scene has no rooms"));
  EXPECT_THAT(faults(""), HasSubstr("f: cannot be read"));
}

}  // namespace
}  // namespace racebeam
