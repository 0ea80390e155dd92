// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/frame_finder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

#include "tb/monitor/vga_monitor.h"
#include "tb/monitor/video_mode.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

/// A chip with two counters from 0: visible pixels first, then front porch, sync, back porch.
struct Chip {
  int width = 640, height = 480, columns = 800, rows = 525, clocks_per_pixel = 1;
  int left = 0;                            // black columns at the left of the visible ones
  int hsync_begin = 656, hsync_end = 752;  // pixels
  int vsync_begin = 490, vsync_end = 492;  // rows
  int vsync_column = 0;                    // pixel in which vsync changes
  int sync_late = 0, picture_late = 0;     // clocks
  bool positive = false;
  int start_row = 0;
  int unreset_clocks = 0;        // after reset, in which both syncs are 0
  double clock_hz = 25'175'000;  // of a pixel

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
    const bool visible = p % columns >= left && p % columns < width && p / columns < height;
    const int colour = visible ? 1 + (p % columns + p / columns) % 63 : 0;
    if (clock < unreset_clocks) return static_cast<std::uint8_t>(pins_of_colour(colour));
    return static_cast<std::uint8_t>(pins_of_colour(colour) | (hsync == positive) << PinHsync |
                                     (vsync == positive) << PinVsync);
  }
  void add_changes(std::vector<PinChange>& all, std::uint64_t from, std::uint64_t to) const {
    for (std::uint64_t clock = from; clock < to; ++clock) {
      const std::uint8_t now = pins(static_cast<std::int64_t>(clock));
      if (all.empty() || all.back().uo != now) all.push_back({clock, now, 0, 0});
    }
  }
  std::vector<PinChange> changes(std::uint64_t clocks) const {
    std::vector<PinChange> all;
    add_changes(all, 0, clocks);
    return all;
  }
  int frame() const { return rows * columns * clocks_per_pixel; }
  FoundFrames found() const {
    std::vector<PinChange> all;
    std::uint64_t known = 0;
    for (int quarter = 9;; quarter += 3) {
      const std::uint64_t clocks = static_cast<std::uint64_t>(frame()) * quarter / 4;
      add_changes(all, std::exchange(known, clocks), clocks);
      if (const auto result = find_frames(all, clocks, clock_hz * clocks_per_pixel)) return *result;
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
    ASSERT_EQ(frame.width, chip.width);
    ASSERT_EQ(frame.height, chip.height);
    for (int y = 0; y < frame.height; ++y)
      for (int x = 0; x < frame.width; ++x)
        ASSERT_EQ(frame.colours[y * frame.width + x], 1 + (x + y) % 63);
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
    EXPECT_TRUE(find_frames(late.changes(clocks), clocks, 25e6)) << row;
  }
  EXPECT_FALSE(find_frames(chip.changes(420'000), 420'000, 25e6));
}

TEST(FrameFinder, RefusesPinsWithoutPulses) {
  Chip chip;
  chip.hsync_end = chip.hsync_begin;
  EXPECT_THAT(chip.complaint(), HasSubstr("hsync, uo_out[7], has no pulses"));
  chip = {};
  chip.vsync_end = chip.vsync_begin;
  EXPECT_THAT(chip.complaint(), HasSubstr("vsync, uo_out[3], has no pulses"));
  EXPECT_THAT(chip.complaint(), HasSubstr("clocks after reset; does the chip need other inputs?"));
}

TEST(FrameFinder, NamesAPinThatLooksLikeHsync) {
  std::vector<PinChange> changes;
  for (int line = 0; line < 7600; ++line) {  // on the pin of red
    changes.push_back({std::uint64_t(line) * 800, 1 << PinR1, 0, 0});
    changes.push_back({std::uint64_t(line) * 800 + 96, 0, 0, 0});
  }
  try {
    find_frames(changes, 6'000'000, 25e6);
    FAIL();
  } catch (const SyncError& error) {
    EXPECT_THAT(error.what(), HasSubstr("uo_out[0] has one every 800 clocks"));
  }
}

TEST(FrameFinder, RefusesFramesThatAreNotWholeLines) {
  std::vector<PinChange> changes;
  for (std::uint64_t clock = 0; clock < 6'100'000; clock += 4) {
    const bool hsync = clock % 800 < 96, vsync = clock % 420'400 < 1600;
    const auto pins = static_cast<std::uint8_t>(hsync << PinHsync | vsync << PinVsync);
    if (changes.empty() || changes.back().uo != pins) changes.push_back({clock, pins, 0, 0});
  }
  EXPECT_FALSE(find_frames(changes, 2'000'000, 25e6));
  EXPECT_THROW(find_frames(changes, 6'000'000, 25e6), SyncError);
}

/// A mode of the table: visible pixels first, as the counters of most chips have them.
Chip chip_of(const VideoMode& mode) {
  Chip chip;
  chip.width = mode.columns;
  chip.height = mode.rows;
  chip.columns = mode.line_pixels();
  chip.rows = mode.lines();
  chip.hsync_begin = mode.columns + mode.front;
  chip.hsync_end = chip.hsync_begin + mode.sync;
  chip.vsync_begin = mode.rows + mode.below;
  chip.vsync_end = chip.vsync_begin + mode.vsync_lines;
  chip.positive = mode.hsync_positive;
  chip.clock_hz = mode.pixel_mhz * 1e6;
  return chip;
}

TEST(FrameFinder, KnowsTheModesOfScreens) {
  for (const char* name : {"640x480 at 75 Hz", "640x480 at 72 Hz", "800x600 at 60 Hz"}) {
    const auto& modes = video_modes();
    const auto mode = std::find_if(modes.begin(), modes.end(),
                                   [&](const VideoMode& m) { return m.name() == name; });
    ASSERT_NE(mode, modes.end());
    Chip chip = chip_of(*mode);
    chip.picture_late = 1;
    expect_checked(chip);
    EXPECT_EQ(chip.found().mode, name);
    EXPECT_EQ(chip.found().picture_late, 1);
    EXPECT_FALSE(chip.found().clock_assumed);
  }
}

TEST(VideoModes, EachIsFoundByItsOwnSyncs) {
  for (const VideoMode& mode : video_modes()) {
    const VideoMode* found = find_video_mode({2 * mode.line_pixels(), 2 * mode.sync, mode.lines(),
                                              mode.hsync_positive, mode.vsync_positive, 0});
    ASSERT_NE(found, nullptr) << mode.name();
    EXPECT_EQ(found->name(), mode.name());
    EXPECT_NEAR(mode.pixel_mhz * 1e6 / mode.line_pixels() / mode.lines(), mode.hertz, 0.9);
  }
}

TEST(FrameFinder, AssumesTheClockThatTheModeNeeds) {
  Chip chip;
  for (const double clock_hz : {0.0, 1e6, 100e6}) {
    chip.clock_hz = clock_hz;
    const FoundFrames found = chip.found();
    EXPECT_TRUE(found.clock_assumed) << clock_hz;
    EXPECT_EQ(found.clock_hz, 25.2e6);
    EXPECT_EQ(found.mode, "640x480 at 60 Hz");
  }
  chip.clock_hz = 23e6;
  EXPECT_FALSE(chip.found().clock_assumed) << "slow, but a screen may follow";
  EXPECT_NEAR(chip.found().frames_per_second(), 54.76, 0.01);
}

TEST(FrameFinder, PixelsNeedNotBeWholeClocks) {
  Chip chip;  // 640x480 at 48 MHz
  chip.width = 1220;
  chip.columns = 1525;
  chip.hsync_begin = 1251;
  chip.hsync_end = 1434;
  chip.clock_hz = 48e6;
  const FoundFrames found = chip.found();
  EXPECT_EQ(found.mode, "640x480 at 60 Hz");
  EXPECT_EQ(found.raster.columns, 640);
  EXPECT_EQ(found.raster.rows, 480);
  EXPECT_EQ(found.raster.line_clocks(), 1525);
  EXPECT_NEAR(found.clocks_per_pixel, 1.906, 0.001);
}

TEST(FrameFinder, EstimatesWhatIsVisibleOfUnknownModes) {
  Chip chip;  // as wide as 480x270, in lines of no screen
  chip.width = 480;
  chip.height = 270;
  chip.columns = 555;
  chip.rows = 301;
  chip.hsync_begin = 500;
  chip.hsync_end = 530;
  chip.vsync_begin = 280;
  chip.vsync_end = 283;
  chip.clock_hz = 0;
  expect_checked(chip);
  const FoundFrames found = chip.found();
  EXPECT_FALSE(found.known_mode);
  EXPECT_EQ(found.mode, "555 clocks by 301 lines");
  EXPECT_TRUE(found.clock_assumed);
  EXPECT_NEAR(found.frames_per_second(), 60, 1e-6);
  chip.left = 400;  // little is seen: the usual part of the line is taken
  EXPECT_GT(chip.found().raster.columns, 400);
  chip.height = 0;
  EXPECT_GT(chip.found().raster.rows, 250) << "black";
}

}  // namespace
}  // namespace racebeam
