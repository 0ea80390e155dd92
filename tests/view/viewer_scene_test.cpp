// The viewer with a scene file: it changes on disk, and its camera leaves its path.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

#include "tb/base/errors.h"
#include "tb/bench/core_bench.h"
#include "tb/scene/scene_reader.h"
#include "tb/view/beam_tlm_source.h"
#include "tb/view/viewer.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

constexpr double Period = 1 / 60.0;
constexpr const char* Scene = R"(
frames = 100
[[room]]
id = "hall"
centre = [0, 0, 0]
half_size = [200, 100, 300]
portals = { north = "yard" }
[[room]]
id = "yard"
centre = [0, 0, 500]
half_size = [100, 80, 200]
[camera]
room = "hall"
velocity = [0, 0, 2]
yaw = { start = 0, step = 1 }
)";

bool in_time() { return true; }

Stage stage_of(const Show& show) {
  const knobs k = show.standard_knobs();
  return {show, std::make_unique<TlmSource>(k, show.program(), false)};
}

class ViewerSceneTest : public testing::Test {
 protected:
  ViewerSceneTest() {
    write(Scene);
    options.scene_file = file;
    options.first = 10;
    options.restage = stage_of;
    viewer = std::make_unique<Viewer>(stage_of(open(file)), options);
    viewer->control.state.paused = true;
    viewer->tick(0, in_time);
  }
  static Show open(const std::string& path) {
    SceneResult result = read_scene_file(path);
    return {std::move(result.scene), "test"};
  }
  void write(const std::string& text) {
    std::ofstream(folder / "new.toml") << text;
    std::filesystem::rename(folder / "new.toml", file);
    std::filesystem::last_write_time(
        file, std::filesystem::file_time_type::clock::now() + std::chrono::seconds(++writes));
  }
  /// What the scene file says, at the frame.
  bool shows(int frame) const {
    const Show show = open(file);
    const auto colours = CoreBench(show.standard_knobs(), frame, show.program()).picture();
    return viewer->source().watch().screen().colours() == colours;
  }
  void press(const char* key) {
    viewer->control.press(key);
    viewer->tick(0, in_time);
  }

  const ScratchFolder folder;
  const std::string file = folder / "scene.toml";
  Viewer::Options options;
  std::unique_ptr<Viewer> viewer;
  int writes = 0;
};

TEST_F(ViewerSceneTest, AChangedFileIsShownAtTheSameFrame) {
  EXPECT_TRUE(shows(10));
  std::string text = Scene;
  write(text + "[look]\npalette = [\"000\", \"300\", \"030\", \"003\"]\n");
  EXPECT_FALSE(shows(10));
  viewer->tick(1, in_time);
  viewer->tick(0, in_time);
  EXPECT_TRUE(shows(10));
  EXPECT_TRUE(viewer->control.state.paused);
  EXPECT_NE(viewer->title().find("loaded again"), std::string::npos);
}

TEST_F(ViewerSceneTest, AShorterSceneIsShownAtItsLastFrame) {
  std::string text = Scene;
  write(text.replace(text.find("100"), 3, "5"));
  viewer->tick(1, in_time);
  viewer->tick(0, in_time);
  EXPECT_TRUE(shows(4));
}

TEST_F(ViewerSceneTest, AFaultyFileKeepsTheOldSceneAndSaysWhatIsWrong) {
  const auto before = viewer->source().watch().screen().colours();
  std::string text = Scene;
  write(text + "[lok]\n");
  viewer->tick(1, in_time);
  EXPECT_NE(viewer->error().find("scene.toml:16:2: unknown key"), std::string::npos)
      << viewer->error();
  EXPECT_NE(viewer->error().find("look"), std::string::npos) << viewer->error();
  EXPECT_EQ(viewer->picture().at(2, 2), (Rgb{150, 20, 20}));
  press(".");
  press("r");
  EXPECT_TRUE(viewer->source().watch().screen().colours() == before);
  write(text);
  viewer->tick(1, in_time);
  EXPECT_EQ(viewer->error(), "");
  viewer->tick(0, in_time);
  EXPECT_TRUE(shows(10));
}

TEST_F(ViewerSceneTest, AFileThatIsGoneForAMomentIsNoNews) {
  std::filesystem::remove(file);
  viewer->tick(1, in_time);
  EXPECT_EQ(viewer->error(), "");
}

TEST_F(ViewerSceneTest, AnObjectionToTheNewSceneIsTold) {
  options.restage = [](const Show&) -> Stage { throw UsageError("not these knobs"); };
  Viewer other(stage_of(open(file)), options);
  std::string text = Scene;
  write(text + "\n");
  other.tick(1, in_time);
  EXPECT_EQ(other.error(), "not these knobs");
}

TEST_F(ViewerSceneTest, FreeFlightStartsOnThePathAndGoesWhereTheKeysSay) {
  const Pose start{0, {0, 0, 18}, 10, 0, 96};
  press("f");
  viewer->tick(0, in_time);
  ASSERT_TRUE(viewer->pose());
  EXPECT_EQ(viewer->pose()->position, start.position);
  EXPECT_EQ(viewer->pose()->yaw, start.yaw);
  EXPECT_TRUE(shows(10));
  viewer->control.press("space");
  viewer->control.press("w");
  for (int i = 0; i < 60; ++i) viewer->tick(Period * 1.01, in_time);
  viewer->control.release("w");
  EXPECT_NEAR(viewer->pose()->position[2], 18 + 240, 12);  // a second at 240 units
  EXPECT_EQ(viewer->pose()->room, 0);
  viewer->control.press("w");
  for (int i = 0; i < 40; ++i) viewer->tick(Period * 1.01, in_time);
  EXPECT_EQ(viewer->show().scene()->rooms[viewer->pose()->room].id, "yard");
  viewer->control.release("w");
  viewer->control.press("right");
  for (int i = 0; i < 30; ++i) viewer->tick(Period * 1.01, in_time);
  EXPECT_NEAR(viewer->pose()->yaw, 10 + 170, 12);
  viewer->control.release("right");
  press("f");
  EXPECT_FALSE(viewer->pose());
  viewer->control.press("p");
  viewer->tick(0, in_time);
  EXPECT_TRUE(shows(10));
}

TEST_F(ViewerSceneTest, ThePauseStopsTheShowAndNotTheCamera) {
  press("f");
  viewer->tick(0, in_time);
  EXPECT_EQ(viewer->message(), "free flight: w a s d, e x, arrows, mouse; f: back to the path");
  const auto colours = [&] { return viewer->source().watch().screen().colours(); };
  const auto still = colours();
  for (int i = 0; i < 60; ++i) viewer->tick(Period, in_time);
  EXPECT_TRUE(colours() == still);
  viewer->control.press("w");
  for (int i = 0; i < 30; ++i) viewer->tick(Period, in_time);
  viewer->control.release("w");
  EXPECT_TRUE(viewer->control.state.paused);
  EXPECT_NEAR(viewer->pose()->position[2], 18 + 120, 6);  // half a second at 240 units
  const auto ahead = colours();
  EXPECT_FALSE(ahead == still);
  EXPECT_TRUE(viewer->source().watch().whole());
  viewer->tick(1, in_time);
  const int before = viewer->pose()->position[0];
  viewer->control.press("d");  // down and up between two ticks
  viewer->control.release("d");
  viewer->tick(Period, in_time);
  EXPECT_NEAR(viewer->pose()->position[0], before + 4, 1);
  EXPECT_TRUE(viewer->take_sound().empty());
  press("l");
  EXPECT_FALSE(viewer->source().watch().whole());
  viewer->control.mouse(100, 0);  // in the middle of a frame
  viewer->tick(Period, in_time);
  EXPECT_TRUE(viewer->source().watch().whole());
  EXPECT_EQ(viewer->pose()->yaw, 10 + 80);
  press("f");
  viewer->tick(0, in_time);
  EXPECT_TRUE(shows(10));
}

TEST_F(ViewerSceneTest, AFlightIsShownInFullWithEveryLineOfThePanel) {
  press("f");
  viewer->tick(0, in_time);
  const auto panel = [&] {
    const RgbImage picture = viewer->picture();
    int lowest = -1;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = VisibleColumns; x < picture.width(); ++x)
        if (picture.at(x, y) != picture.at(VisibleColumns, y)) lowest = y;
    return lowest;
  };
  press("g");
  press("t");
  EXPECT_LT(panel(), VisibleRows - 3);
}

TEST_F(ViewerSceneTest, TheMouseLooksAround) {
  press("f");
  viewer->control.mouse(100, 50);
  press(".");
  EXPECT_EQ(viewer->pose()->yaw, 10 + 80);
  EXPECT_EQ(viewer->pose()->pitch, 40);
}

}  // namespace
}  // namespace racebeam
