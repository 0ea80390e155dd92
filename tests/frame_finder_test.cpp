// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/frame_finder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tb/vga_monitor.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

/// A chip with two counters from 0: visible pixels first, then front porch, sync, back porch.
struct Chip {
  int width = 640, columns = 800, rows = 525, clocks_per_pixel = 1;
  int hsync_begin = 656, hsync_end = 752;  // pixels
  int vsync_begin = 490, vsync_end = 492;  // rows
  int vsync_column = 0;                    // pixel in which vsync changes
  int sync_late = 0, picture_late = 0;     // clocks
  bool positive = false;
  int start_row = 0;
  int unreset_clocks = 0;  // after reset, in which both syncs are 0

  std::uint8_t pins(std::int64_t clock) const {
    const auto at = [this](std::int64_t clock) {
      const std::int64_t frame = std::int64_t(rows) * columns;
      return (clock / clocks_per_pixel + std::int64_t(start_row) * columns + frame) % frame;
    };
    const int s = static_cast<int>(at(clock - sync_late + 8 * columns * clocks_per_pixel * rows));
    const int p =
        static_cast<int>(at(clock - picture_late + 8 * columns * clocks_per_pixel * rows));
    const int h = s % columns;
    const bool hsync = h >= hsync_begin && h < hsync_end;
    const bool vsync =
        s >= vsync_begin * columns + vsync_column && s < vsync_end * columns + vsync_column;
    const bool visible = p % columns < width && p / columns < 480;
    const int colour = visible ? 1 + (p % columns + p / columns) % 63 : 0;
    if (clock < unreset_clocks) return static_cast<std::uint8_t>(pins_of_colour(colour));
    return static_cast<std::uint8_t>(pins_of_colour(colour) | (hsync == positive) << PinHsync |
                                     (vsync == positive) << PinVsync);
  }
  std::vector<PinChange> changes(std::uint64_t clocks) const {
    std::vector<PinChange> all;
    for (std::uint64_t clock = 0; clock < clocks; ++clock) {
      const std::uint8_t now = pins(static_cast<std::int64_t>(clock));
      if (all.empty() || all.back().uo != now) all.push_back({clock, now, 0, 0});
    }
    return all;
  }
  int frame() const { return rows * columns * clocks_per_pixel; }
  FoundFrames found() const {
    for (int quarter = 9;; quarter += 3) {
      const std::uint64_t clocks = static_cast<std::uint64_t>(frame()) * quarter / 4;
      if (const auto result = find_frames(changes(clocks), clocks, clocks_per_pixel))
        return *result;
    }
  }
  std::string complaint() const {
    try {
      found();
    } catch (const SyncError& error) {
      return error.what();
    }
    return "";
  }
};

/// The monitor takes the first frame as it was found and sees the whole picture.
void expect_checked(const Chip& chip) {
  const FoundFrames found = chip.found();
  EXPECT_LT(found.first, static_cast<std::uint64_t>(chip.frame()));
  VgaMonitor monitor(found.raster, [&](const VgaFrame& frame) {
    for (int y = 0; y < 480; ++y)
      for (int x = 0; x < 640; ++x) ASSERT_EQ(frame.colours[y * 640 + x], 1 + (x + y) % 63);
  });
  for (int clock = 0; clock < chip.frame(); ++clock)
    monitor.change(clock, chip.pins(static_cast<std::int64_t>(found.first) + clock));
  EXPECT_NO_THROW(monitor.advance(chip.frame()));
  EXPECT_EQ(monitor.frames(), 1u);
}

TEST(FrameFinder, FindsCountersThatStartAtTheFirstPixel) {
  const Chip chip;
  const FoundFrames found = chip.found();
  EXPECT_EQ(found.first, 491u * 800 + 640) << "front porch of the line after vsync";
  EXPECT_EQ(found.picture_late, 0);
  EXPECT_EQ(found.raster.vsync_at, 160) << "where the visible columns begin";
  EXPECT_FALSE(found.raster.hsync_pulse);
  EXPECT_FALSE(found.raster.vsync_pulse);
  expect_checked(chip);
}

TEST(FrameFinder, FindsFramesThatStartAnywhere) {
  for (const int row : {1, 300, 489, 490, 491, 492, 524}) {
    Chip chip;
    chip.start_row = row;
    expect_checked(chip);
  }
}

TEST(FrameFinder, FindsVsyncThatChangesAnywhereInTheLine) {
  for (const int column : {-160, -159, -144, -48, -1, 1, 639}) {
    Chip chip;
    chip.vsync_column = column;
    expect_checked(chip);
  }
}

TEST(FrameFinder, FindsPositiveSyncs) {
  Chip chip;
  chip.positive = true;
  const FoundFrames found = chip.found();
  EXPECT_TRUE(found.raster.hsync_pulse);
  EXPECT_TRUE(found.raster.vsync_pulse);
  expect_checked(chip);
}

TEST(FrameFinder, FindsPicturesThatAreEarlyOrLate) {
  for (const int late : {-8, -1, 1, 2, 8}) {
    Chip chip;
    (late < 0 ? chip.sync_late : chip.picture_late) = std::abs(late);
    EXPECT_EQ(chip.found().picture_late, late);
    expect_checked(chip);
  }
}

TEST(FrameFinder, LeavesPicturesAloneThatAreTooFarOffOrTooWide) {
  Chip far;
  far.picture_late = 9;
  EXPECT_EQ(far.found().picture_late, 0);
  Chip wide;
  wide.width = 642;
  EXPECT_EQ(wide.found().picture_late, 0);
}

TEST(FrameFinder, TakesAnyClocksPerPixel) {
  for (const int clocks : {2, 3}) {
    Chip chip;
    chip.clocks_per_pixel = clocks;
    chip.sync_late = 1;
    EXPECT_EQ(chip.found().picture_late, -1);
    EXPECT_EQ(chip.found().raster.line_clocks(), 800 * clocks);
  }
}

TEST(FrameFinder, KnowsLinesThatTheSpeedPinsShorten) {
  Chip chip;
  chip.clocks_per_pixel = 2;
  chip.columns = 750;
  EXPECT_EQ(chip.found().raster.line_clocks(), Raster(2, 1).line_clocks());
}

TEST(FrameFinder, WhatSyncsDoInTheFirstLineDoesNotCount) {
  for (const bool positive : {false, true}) {
    Chip chip;
    chip.positive = positive;
    chip.unreset_clocks = 3;
    expect_checked(chip);
  }
}

TEST(FrameFinder, WantsNoMoreThanTwoFramesAndALine) {
  const Chip chip;
  const std::uint64_t clocks = 2 * 420'000 + 1600;
  for (const int row : {0, 200, 491, 492}) {
    Chip late = chip;
    late.start_row = row;
    EXPECT_TRUE(find_frames(late.changes(clocks), clocks, 1)) << row;
  }
  EXPECT_FALSE(find_frames(chip.changes(420'000), 420'000, 1));
}

TEST(FrameFinder, RefusesPinsWithoutPulses) {
  Chip chip;
  chip.hsync_end = chip.hsync_begin;
  EXPECT_THAT(chip.complaint(), HasSubstr("hsync, uo_out[7], has no pulses"));
  chip = {};
  chip.vsync_end = chip.vsync_begin;
  EXPECT_THAT(chip.complaint(), HasSubstr("vsync, uo_out[3], has no pulses"));
  EXPECT_THAT(chip.complaint(), HasSubstr("in the 1260000 clocks after reset, 3 frames"));
}

TEST(FrameFinder, RefusesOtherModes) {
  Chip chip;
  chip.columns = 1056;  // 800x600
  EXPECT_THAT(chip.complaint(), HasSubstr("a line lasts 1056 clocks from hsync to hsync, must last "
                                          "800: only 640x480 at 60 Hz is known"));
  chip = {};
  chip.rows = 524;
  EXPECT_THAT(chip.complaint(), HasSubstr("a frame lasts 419200 clocks from vsync to vsync, must "
                                          "last 420000: 525 lines of 800 clocks"));
}

}  // namespace
}  // namespace racebeam
