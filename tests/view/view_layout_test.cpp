// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/view_layout.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sc/base/constants.h"
#include "tb/view/map_picture.h"
#include "tb/view/view_picture.h"

namespace racebeam {
namespace {

constexpr Extent Screens[] = {{1024, 768},  {1280, 720},  {1366, 768},  {1280, 1024},
                              {1600, 1200}, {1920, 1080}, {2560, 1440}, {3840, 2160}};
constexpr Extent Bare{VisibleColumns, VisibleRows};
constexpr Extent Pictures[] = {Bare,
                               {Bare.width, Bare.height + MapBarHeight},
                               {Bare.width + PanelWidth, Bare.height},
                               {Bare.width + PanelWidth, Bare.height + MapBarHeight}};

TEST(ViewLayout, EveryPictureFitsEveryScreenInItsOwnPixelsOrLarger) {
  for (const Extent screen : Screens)
    for (const Extent picture : Pictures) {
      const double scale = fit_scale(picture, window_room(screen));
      const Extent window = scaled(picture, scale);
      EXPECT_GE(scale, 1) << screen.width;
      EXPECT_LE(window.width, screen.width);
      EXPECT_LE(window.height, screen.height - 48) << "a title has room";
      EXPECT_EQ(scale * 4, std::floor(scale * 4));
      const Extent larger = scaled(picture, scale * 1.5);
      EXPECT_TRUE(larger.width > screen.width || larger.height > screen.height - 48)
          << screen.width << ' ' << picture.width << " could be larger than " << scale;
    }
}

TEST(ViewLayout, CommonScreens) {
  const auto bare = [](Extent screen) { return fit_scale(Bare, window_room(screen)); };
  const auto all = [](Extent screen) { return fit_scale(Pictures[3], window_room(screen)); };
  EXPECT_EQ(bare({1280, 720}), 1.25);
  EXPECT_EQ(all({1280, 720}), 1.25);
  EXPECT_EQ(bare({1366, 768}), 1.5);
  EXPECT_EQ(all({1366, 768}), 1.25);
  EXPECT_EQ(bare({1600, 1200}), 2);
  EXPECT_EQ(all({1600, 1200}), 1.75);
  EXPECT_EQ(bare({1920, 1080}), 2);
  EXPECT_EQ(all({1920, 1080}), 1.75);
  EXPECT_EQ(bare({3840, 2160}), 4);
}

TEST(ViewLayout, AWholeScaleIsTakenWhereItCostsLittle) {
  EXPECT_EQ(fit_scale({100, 100}, {225, 225}), 2);
  EXPECT_EQ(fit_scale({100, 100}, {250, 250}), 2.5);
  EXPECT_EQ(fit_scale({100, 100}, {350, 350}), 3);
  EXPECT_EQ(fit_scale({100, 100}, {124, 900}), 1);
}

TEST(ViewLayout, ASmallWindowShowsTheWholePicture) {
  const Box box = picture_in({640, 480}, {320, 480});
  EXPECT_EQ(box.size, (Extent{320, 240}));
  EXPECT_EQ(box.left, 0);
  EXPECT_EQ(box.top, 120);
  EXPECT_EQ(picture_in({640, 480}, {1, 1}).size, (Extent{1, 1}));
}

TEST(ViewLayout, AWindowThatGrowsMovesOntoItsScreenAndNoFarther) {
  const Box screen{100, 30, {1000, 700}};
  const auto kept = [&](int left, int top, Extent size) {
    const Box box = kept_within({left, top, size}, screen);
    return std::pair{box.left, box.top};
  };
  EXPECT_EQ(kept(200, 100, {300, 300}), std::pair(200, 100));
  EXPECT_EQ(kept(900, 600, {300, 300}), std::pair(800, 430));
  EXPECT_EQ(kept(0, 0, {300, 300}), std::pair(100, 30));
  EXPECT_EQ(kept(500, 500, {2000, 2000}), std::pair(100, 30)) << "too large: its top left is seen";
}

}  // namespace
}  // namespace racebeam
