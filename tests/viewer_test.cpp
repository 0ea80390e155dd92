// The viewer without a window: time and keys go in, pictures come out.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/viewer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tb/core_bench.h"
#include "tb/errors.h"
#include "tb/view/map_picture.h"
#include "tb/view/tlm_source.h"

namespace racebeam {
namespace {

constexpr double Period = 1 / 60.0;
constexpr int LineClocks = 2 * LinePixels;
constexpr Rgb BeamColour{255, 64, 220};

bool in_time() { return true; }

class ViewerTest : public testing::Test {
 protected:
  static Stage demo() {
    const Show show;
    return {show, knobs{}, std::make_unique<TlmSource>(knobs{})};
  }
  static Viewer::Options at(int first) {
    Viewer::Options options;
    options.first = first;
    options.demo_file = []() -> Show { throw UsageError("no file here"); };
    return options;
  }
  static std::vector<Rgb> pixels(const RgbImage& picture) {
    std::vector<Rgb> all;
    for (int y = 0; y < VisibleRows; ++y)
      for (int x = 0; x < VisibleColumns; ++x) all.push_back(picture.at(x, y));
    return all;
  }
  /// A frame of the demo as the bench renders it.
  static std::vector<Rgb> frame(int number) {
    std::vector<Rgb> all;
    for (const int colour : CoreBench({}, number).picture()) all.push_back(rgb_of(colour));
    return all;
  }
  static void press(Viewer& viewer, const char* key) {
    viewer.control.press(key);
    viewer.tick(0, in_time);
  }
};

TEST_F(ViewerTest, FirstPictureIsTheFirstFrameEvenWhenPaused) {
  Viewer viewer(demo(), at(5000));
  viewer.control.state.paused = true;
  viewer.tick(0, in_time);
  EXPECT_EQ(viewer.picture().width(), VisibleColumns);
  EXPECT_EQ(viewer.picture().height(), VisibleRows);
  EXPECT_TRUE(pixels(viewer.picture()) == frame(5000));
  viewer.tick(10, in_time);
  EXPECT_TRUE(pixels(viewer.picture()) == frame(5000));
}

TEST_F(ViewerTest, ShowsTheFrameThatIsDueAndLeavesOutThoseThatAreLate) {
  Viewer viewer(demo(), at(60));
  viewer.tick(0, in_time);
  viewer.tick(Period * 1.001, in_time);
  EXPECT_EQ(viewer.source().watch().frame(), 61);
  viewer.tick(Period * 4, in_time);
  EXPECT_EQ(viewer.source().watch().frame(), 65);
  EXPECT_TRUE(pixels(viewer.picture()) == frame(65));
}

TEST_F(ViewerTest, WithANumberOfFramesNoneIsLeftOutAndThenItStands) {
  auto options = at(60);
  options.frames = 3;
  Viewer viewer(demo(), options);
  for (const int expected : {60, 61, 62, 62}) {
    viewer.tick(Period * 4, in_time);
    EXPECT_EQ(viewer.source().watch().frame(), expected);
  }
  EXPECT_TRUE(viewer.finished());
}

TEST_F(ViewerTest, StepsGoOnByAFrameALineAPixelAClock) {
  Viewer viewer(demo(), at(60));
  viewer.tick(0, in_time);
  const FrameWatch& watch = viewer.source().watch();
  press(viewer, ".");
  EXPECT_EQ(watch.frame(), 61);
  EXPECT_TRUE(watch.whole());
  press(viewer, "l");
  EXPECT_EQ(watch.seen(), LineClocks);
  press(viewer, "c");
  EXPECT_EQ(watch.seen(), LineClocks + 1);
  press(viewer, "l");
  EXPECT_EQ(watch.seen(), 2 * LineClocks);
  press(viewer, "k");
  EXPECT_EQ(watch.seen(), 2 * LineClocks + 2);
  press(viewer, "c");
  press(viewer, "k");
  EXPECT_EQ(watch.seen(), 2 * LineClocks + 4);
  press(viewer, ".");
  EXPECT_TRUE(watch.whole());
  EXPECT_EQ(watch.frame(), 62);
  EXPECT_TRUE(pixels(viewer.picture()) == frame(62));
}

TEST_F(ViewerTest, SlowMotionStopsInTheMiddleOfAFrame) {
  Viewer viewer(demo(), at(60));
  viewer.tick(0, in_time);
  for (int i = 0; i < 6; ++i) viewer.control.press("-");
  viewer.tick(32 * Period, in_time);  // half a frame, but what lags behind is let go
  const int seen = viewer.source().watch().seen();
  EXPECT_EQ(seen, static_cast<int>(0.25 * 60 / 64 * LineClocks * FrameLines));
  EXPECT_EQ(viewer.source().watch().frame(), 61);
}

TEST_F(ViewerTest, TheBeamIsMarkedWhereItStands) {
  Viewer viewer(demo(), at(60));
  viewer.tick(0, in_time);
  for (int line = FirstLine; line < 17; ++line) press(viewer, "l");
  for (int pixel = 0; pixel < LinePixels - VisibleColumns + 200; ++pixel) press(viewer, "k");
  press(viewer, "b");
  const RgbImage picture = viewer.picture();
  EXPECT_EQ(picture.at(200, 17 + 240), BeamColour);
  EXPECT_EQ(picture.at(200, 17 + 243), BeamColour);
  EXPECT_NE(picture.at(200, 17 + 246), BeamColour);
  press(viewer, "b");
  EXPECT_NE(viewer.picture().at(200, 17 + 243), BeamColour);
}

TEST_F(ViewerTest, RewindAndLeapsShowTheirFrame) {
  Viewer viewer(demo(), at(6200));
  viewer.control.state.paused = true;
  viewer.tick(0, in_time);
  press(viewer, "right");
  EXPECT_TRUE(pixels(viewer.picture()) == frame(6260));
  press(viewer, "left");
  press(viewer, "left");
  EXPECT_TRUE(pixels(viewer.picture()) == frame(6140));
  press(viewer, "r");
  EXPECT_TRUE(pixels(viewer.picture()) == frame(6200));
}

TEST_F(ViewerTest, AMapReplacesThePictureAndBringsItsBar) {
  Viewer viewer(demo(), at(7223));
  viewer.control.state.paused = true;
  viewer.tick(0, in_time);
  press(viewer, "1");
  const RgbImage picture = viewer.picture();
  const RgbImage map = map_picture(
      make_map(MapKind::Slack, viewer.source().watch().intervals(), Raster()), "demo frame 7223");
  ASSERT_EQ(picture.height(), map.height());
  EXPECT_TRUE(
      std::equal(map.bytes(), map.bytes() + 3 * map.width() * map.height(), picture.bytes()));
  press(viewer, "1");
  EXPECT_TRUE(pixels(viewer.picture()) == frame(7223));
}

TEST_F(ViewerTest, ThePanelLeavesThePictureAsItIs) {
  Viewer viewer(demo(), at(7223));
  viewer.control.state.paused = true;
  viewer.tick(0, in_time);
  press(viewer, "g");
  press(viewer, "t");
  EXPECT_EQ(viewer.picture().width(), VisibleColumns + PanelWidth);
  EXPECT_TRUE(pixels(viewer.picture()) == frame(7223));
}

TEST_F(ViewerTest, BordersStandOnTheLastColumnOfEachInterval) {
  Viewer viewer(demo(), at(60));
  viewer.control.state.paused = true;
  viewer.tick(0, in_time);
  press(viewer, "i");
  auto expected = frame(60);
  for (const IntervalEvent& event : viewer.source().watch().intervals())
    if (event.to < LastPixel)
      expected[(event.y - FirstVisibleLine) * VisibleColumns + event.to + 1] = {64, 255, 160};
  EXPECT_TRUE(pixels(viewer.picture()) == expected);
}

TEST_F(ViewerTest, PlaysTheSoundOfEveryFrameAtFullSpeedOnly) {
  Viewer viewer(demo(), at(6200));
  viewer.tick(0, in_time);
  viewer.tick(Period * 3.001, in_time);
  EXPECT_EQ(viewer.take_sound().size(), 3u * FrameSamples);
  press(viewer, "m");
  viewer.tick(Period * 3.001, in_time);
  EXPECT_TRUE(viewer.take_sound().empty());
  press(viewer, "m");
  press(viewer, "+");
  viewer.tick(Period * 3.001, in_time);
  EXPECT_TRUE(viewer.take_sound().empty());
}

TEST_F(ViewerTest, NoFileForTheDemoIsTold) {
  Viewer viewer(demo(), at(60));
  viewer.control.state.paused = true;
  viewer.tick(0, in_time);
  press(viewer, "f");
  EXPECT_FALSE(viewer.pose());
  EXPECT_NE(viewer.title().find("no file here"), std::string::npos) << viewer.title();
}

TEST_F(ViewerTest, EscapeQuits) {
  Viewer viewer(demo(), at(60));
  EXPECT_FALSE(viewer.quit());
  press(viewer, "escape");
  EXPECT_TRUE(viewer.quit());
}

}  // namespace
}  // namespace racebeam
