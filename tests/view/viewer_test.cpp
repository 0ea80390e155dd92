// The viewer without a window: time and keys go in, pictures come out.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/viewer.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tb/base/errors.h"
#include "tb/bench/core_bench.h"
#include "tb/view/beam_tlm_source.h"
#include "tb/view/map_picture.h"
#include "tests/support/gif_delays.h"
#include "tests/support/scratch_folder.h"

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
    return {show, std::make_unique<TlmSource>(knobs{})};
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
  press(viewer, "k");
  EXPECT_EQ(watch.seen(), 2);
  press(viewer, "c");
  press(viewer, "k");
  EXPECT_EQ(watch.seen(), 4);
  const int first = -FirstLine + FirstVisibleLine;  // lines before it
  press(viewer, "l");
  EXPECT_EQ(watch.seen(), (first + 1) * LineClocks);
  press(viewer, "c");
  EXPECT_EQ(watch.seen(), (first + 1) * LineClocks + 1);
  press(viewer, "l");
  EXPECT_EQ(watch.seen(), (first + 2) * LineClocks);
  press(viewer, "j");
  EXPECT_EQ(watch.seen(), (first + 12) * LineClocks);
  press(viewer, ".");
  EXPECT_TRUE(watch.whole());
  EXPECT_EQ(watch.frame(), 62);
  EXPECT_TRUE(pixels(viewer.picture()) == frame(62));
}

TEST_F(ViewerTest, EachStepByALineShowsOneMoreAndTheLastEndsTheFrame) {
  Viewer viewer(demo(), at(60));
  viewer.tick(0, in_time);
  press(viewer, ".");
  const auto before = frame(61), after = frame(62);
  for (int lines = 0; lines < VisibleRows;) {
    const bool ten = lines >= 5 && lines < VisibleRows - 5;
    press(viewer, ten ? "j" : "l");
    lines += ten ? 10 : 1;
    auto expected = before;
    std::copy_n(after.begin(), lines * VisibleColumns, expected.begin());
    ASSERT_TRUE(pixels(viewer.picture()) == expected) << lines;
  }
  EXPECT_FALSE(viewer.source().watch().whole());
  press(viewer, "l");
  EXPECT_TRUE(viewer.source().watch().whole());
  EXPECT_EQ(viewer.source().watch().frame(), 62);
}

TEST_F(ViewerTest, AStepSaysWhereTheBeamIs) {
  Viewer viewer(demo(), at(60));
  viewer.tick(0, in_time);
  const std::pair<const char*, const char*> steps[] = {{".", "frame 61"},
                                                       {"c", "line -273, not visible, clock 1"},
                                                       {"l", "line -239, clock 0"},
                                                       {"j", "line -229, clock 0"},
                                                       {"k", "line -229, clock 2"},
                                                       {"right", "frame 122"},
                                                       {"r", "frame 60"}};
  for (const auto& [key, message] : steps) {
    press(viewer, key);
    EXPECT_EQ(viewer.message(), message);
  }
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
  for (int line = FirstVisibleLine; line < 17; ++line) press(viewer, "l");
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
  const RgbImage map = map_picture(make_map(MapKind::Slack, viewer.source().intervals(), Raster()),
                                   "demo frame 7223");
  ASSERT_EQ(picture.height(), map.height());
  EXPECT_TRUE(
      std::equal(map.bytes(), map.bytes() + 3 * map.width() * map.height(), picture.bytes()));
  press(viewer, "1");
  EXPECT_TRUE(pixels(viewer.picture()) == frame(7223));
}

TEST_F(ViewerTest, ThePanelHasRoomForAllOfItsLines) {
  Viewer viewer(demo(), at(7223));
  viewer.control.state.paused = true;
  viewer.tick(0, in_time);
  const auto lowest = [&] {  // row with the last ink of the panel
    const RgbImage picture = viewer.picture();
    for (int y = picture.height() - 1; y >= 0; --y)
      for (int x = VisibleColumns; x < picture.width(); ++x)
        if (picture.at(x, y) != picture.at(VisibleColumns, y)) return y;
    return -1;
  };
  press(viewer, "g");
  const int gauges = lowest();
  press(viewer, "t");
  EXPECT_GT(lowest(), gauges + 100);
  EXPECT_LT(lowest(), VisibleRows - 3);
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
  for (const IntervalEvent& event : viewer.source().intervals())
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

TEST_F(ViewerTest, AMessageLiesOverTheBottomOfThePictureForTwoSeconds) {
  Viewer viewer(demo(), at(60));
  viewer.control.state.paused = true;
  viewer.tick(0, in_time);
  EXPECT_TRUE(pixels(viewer.picture_with_message()) == frame(60));
  press(viewer, "m");
  EXPECT_EQ(viewer.message(), "sound off");
  for (const double more : {0.0, 1.9}) {
    viewer.tick(more, in_time);
    const auto shown = pixels(viewer.picture_with_message());
    const auto plain = frame(60);
    constexpr int Above = VisibleColumns * (VisibleRows - 19);
    EXPECT_TRUE(std::equal(plain.begin(), plain.begin() + Above, shown.begin()));
    RgbImage words(VisibleColumns, VisibleRows);
    words.text(8, VisibleRows - 16, "sound off", {235, 235, 235});
    for (int y = VisibleRows - 19; y < VisibleRows; ++y)
      for (int x = 0; x < VisibleColumns; ++x)
        ASSERT_EQ(shown[y * VisibleColumns + x] == (Rgb{235, 235, 235}),
                  words.at(x, y) == (Rgb{235, 235, 235}))
            << x << ',' << y;
    EXPECT_TRUE(pixels(viewer.picture()) == plain) << "screenshots are without it";
  }
  viewer.take_changed();
  viewer.tick(0.2, in_time);
  EXPECT_TRUE(viewer.take_changed());
  EXPECT_TRUE(pixels(viewer.picture_with_message()) == frame(60));
}

TEST_F(ViewerTest, AMessageKeepsAwayFromTheBeam) {
  Viewer viewer(demo(), at(60));
  viewer.tick(0, in_time);
  for (int lines = 0; lines < 300; lines += 10) press(viewer, "j");
  const auto shown = pixels(viewer.picture_with_message()), plain = pixels(viewer.picture());
  EXPECT_TRUE(std::equal(plain.begin() + VisibleColumns * 19, plain.end(),
                         shown.begin() + VisibleColumns * 19));
  EXPECT_FALSE(shown == plain);
}

TEST_F(ViewerTest, KeysThatDoNothingHereSayWhy) {
  Viewer viewer(demo(), at(60));
  viewer.tick(0, in_time);
  const std::pair<const char*, const char*> answers[] = {
      {"w", "that key flies, but only in a free flight: f"},
      {"f5", "the built-in demo has no file to load again"},
      {"-", "speed 1/2 x"},
      {"m", "sound off"},
      {"m", "sound on, heard at speed 1 x only"},
      {"p", "paused"}};
  for (const auto& [key, answer] : answers) {
    press(viewer, key);
    EXPECT_EQ(viewer.message(), answer);
  }
  EXPECT_EQ(viewer.error(), "");
  EXPECT_TRUE(viewer.take_news().empty()) << "for the screen only";
}

TEST_F(ViewerTest, AClickNamesTheCommandThatExplainsThePixel) {
  auto options = at(7223);
  options.explain = "explain demo --set fifo_entries=6";
  Viewer viewer(demo(), options);
  viewer.control.state.paused = true;
  viewer.tick(0, in_time);
  viewer.control.click(320, 100);
  viewer.tick(0, in_time);
  const std::string command =
      "racebeam explain demo --set fifo_entries=6 --frame 7223 --pixel 320,100";
  EXPECT_EQ(viewer.take_news(), std::vector<std::string>{"to know why: " + command});
  EXPECT_EQ(viewer.message().substr(0, command.size()), command);
  EXPECT_NE(viewer.message().find("\npixels "), std::string::npos) << viewer.message();
  press(viewer, "l");
  viewer.control.click(0, 1);
  viewer.tick(0, in_time);
  EXPECT_EQ(viewer.message(), "pixel 0,1: the beam has not come there yet");
  viewer.control.click(639, 0);
  viewer.tick(0, in_time);
  EXPECT_NE(viewer.message().find("--frame 7224 --pixel 639,0"), std::string::npos);
}

TEST_F(ViewerTest, ARecordingLastsAsLongAsItsPartOfTheShow) {
  const ScratchFolder folder;
  auto options = at(60);
  options.folder = folder.path();
  Viewer viewer(demo(), options);
  viewer.tick(0, in_time);
  press(viewer, "v");
  EXPECT_EQ(viewer.message(), "recording " + (folder / "view_0060.gif") + "; v: stop");
  for (const int passed : {1, 4, 4, 1, 7, 12}) viewer.tick(Period * (passed + 0.01), in_time);
  press(viewer, "+");
  viewer.tick(Period * 3.01, in_time);  // six frames of the show
  EXPECT_EQ(viewer.source().watch().frame(), 60 + 29 + 6);
  press(viewer, "v");
  const std::string said = "wrote " + (folder / "view_0060.gif") + ", 0.60 s in 8 pictures";
  EXPECT_EQ(viewer.message(), said);
  EXPECT_EQ(viewer.take_news(), std::vector<std::string>{said});
  EXPECT_EQ(gif_delays(folder / "view_0060.gif"), (std::vector<int>{2, 6, 7, 2, 11, 20, 10, 2}));
}

TEST_F(ViewerTest, EscapeQuits) {
  Viewer viewer(demo(), at(60));
  EXPECT_FALSE(viewer.quit());
  press(viewer, "escape");
  EXPECT_TRUE(viewer.quit());
}

}  // namespace
}  // namespace racebeam
