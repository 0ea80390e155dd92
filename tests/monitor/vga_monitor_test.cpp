// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/vga_monitor.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>
#include <vector>

namespace racebeam {
namespace {

constexpr int LineClocks = 1600, FrameClocks = 840000;
constexpr int White = 0x77, Hsync = 0x80, Vsync = 0x08;

/// A picture in which every pixel differs from its left neighbour.
int picture(int x, int y) { return (x + 3 * y) % 61; }

/// The pins of every clock, straight from the contract's tables (default raster).
class Pins {
 public:
  explicit Pins(int frames = 1) : pins_(static_cast<std::size_t>(frames) * FrameClocks) {
    for (std::size_t i = 0; i < pins_.size(); ++i) {
      const int c = static_cast<int>(i % LineClocks);
      const int y = static_cast<int>(i / LineClocks % 525) - 273;
      const bool in_vsync = y * LineClocks + c >= 250 * LineClocks + 224 ||
                            y * LineClocks + c < -273 * LineClocks + 224;
      const bool visible = c >= 320 && y >= -240 && y < 240;
      pins_[i] = (c >= 32 && c < 224 ? 0 : Hsync) | (in_vsync ? 0 : Vsync) |
                 (visible ? pins_of_colour(picture((c - 320) / 2, y + 240)) : 0);
    }
  }
  std::uint8_t& at(int y, int c, int frame = 0) {
    return pins_[static_cast<std::size_t>(frame) * FrameClocks + (y + 273) * LineClocks + c];
  }
  void flip(int mask, int y, int first, int last, int frame = 0) {
    for (int c = first; c <= last; ++c) at(y, c, frame) ^= mask;
  }
  void feed(VgaMonitor& monitor) const {
    for (std::size_t i = 0; i < pins_.size(); ++i)
      if (i == 0 || pins_[i] != pins_[i - 1]) monitor.change(i, pins_[i]);
    monitor.advance(pins_.size());
  }
  /// What the monitor says, or "good".
  std::string verdict(const Raster& raster = Raster()) const {
    try {
      VgaMonitor monitor(raster, nullptr);
      feed(monitor);
    } catch (const SyncError& error) {
      return error.what();
    }
    return "good";
  }
  const std::vector<std::uint8_t>& all() const { return pins_; }

 private:
  std::vector<std::uint8_t> pins_;
};

TEST(Raster, DefaultLineHasTheContractsClocks) {
  const Raster r;
  EXPECT_EQ(r.line_clocks(), 1600);
  EXPECT_EQ(r.sync_begin, 32);
  EXPECT_EQ(r.sync_end, 224);
  EXPECT_EQ(r.active_begin, 320);
  EXPECT_EQ(r.clocks[0].position, -480);
  EXPECT_EQ(r.clocks[1599].position, 319);
  for (int c = 0; c < 1600; ++c) {
    EXPECT_EQ(r.clocks[c].last, c % 2 == 1);
    EXPECT_EQ(r.clocks[c].hsync, c < 32 || c >= 224);
  }
  EXPECT_EQ(r.column_at[321], 0);
  EXPECT_EQ(r.column_at[322], 1);
  EXPECT_EQ(r.column_at[1600], 640);
}

TEST(Raster, SpeedPinsGiveTheMeasuredFrameLengths) {
  EXPECT_EQ(Raster(2, 0).frame_clocks(), 840000);
  EXPECT_EQ(Raster(2, 1).frame_clocks(), 787500);
  EXPECT_EQ(Raster(2, 2).frame_clocks(), 735000);
  EXPECT_EQ(Raster(2, 4).frame_clocks(), 761250);
  EXPECT_EQ(Raster(2, 7).frame_clocks(), 603750);
}

TEST(Raster, ClocksPerPixelScaleTheLine) {
  for (int clocks = 1; clocks <= 8; ++clocks) EXPECT_EQ(Raster(clocks).line_clocks(), 800 * clocks);
  EXPECT_EQ(Raster(1, 7).line_clocks(), 800) << "a pixel has at least one clock";
  EXPECT_THROW(Raster(0), std::invalid_argument);
  EXPECT_THROW(Raster(2, 8), std::invalid_argument);
}

TEST(VgaPins, ContractsTraceDecodes) {
  EXPECT_EQ(colour_of_pins(0x88), 0);
  EXPECT_EQ(colour_of_pins(0xcf), 2 << 4 | 2 << 2 | 3);
  EXPECT_EQ(colour_of_pins(0xac), 1 << 2 | 2);
  for (int colour = 0; colour < 64; ++colour)
    EXPECT_EQ(colour_of_pins(pins_of_colour(colour)), colour);
}

TEST(VgaMonitor, GoodFramesAreHandedOnInOrder) {
  std::vector<std::uint64_t> seen;
  VgaMonitor monitor(Raster(), [&](const VgaFrame& frame) {
    seen.push_back(frame.index);
    ASSERT_EQ(frame.colours.size(), 640u * 480);
    for (int y = 0; y < 480; ++y)
      for (int x = 0; x < 640; ++x) ASSERT_EQ(frame.colours[y * 640 + x], picture(x, y));
    EXPECT_EQ(frame.image_crc, 0u);
    EXPECT_EQ(frame.pins_crc, 0u);
  });
  Pins(3).feed(monitor);
  EXPECT_EQ(seen, (std::vector<std::uint64_t>{0, 1, 2}));
  EXPECT_EQ(monitor.frames(), 3u);
}

TEST(VgaMonitor, FrameIsWholeWhenItsLastClockIsKnown) {
  VgaMonitor monitor(Raster(), nullptr);
  const Pins pins;
  for (int i = 0; i < FrameClocks; ++i) monitor.change(i, pins.all()[i]);
  monitor.advance(FrameClocks - 1);
  EXPECT_EQ(monitor.frames(), 0u);
  monitor.advance(FrameClocks);
  EXPECT_EQ(monitor.frames(), 1u);
}

TEST(VgaMonitor, PixelIsTakenInItsSecondClock) {
  Pins pins;
  pins.at(5, 320 + 2 * 100) = Hsync | Vsync | White;      // first clock only
  pins.at(5, 320 + 2 * 200 + 1) = Hsync | Vsync | White;  // second clock only
  VgaMonitor monitor(Raster(), [](const VgaFrame& frame) {
    EXPECT_EQ(frame.colours[245 * 640 + 100], picture(100, 245));
    EXPECT_EQ(frame.colours[245 * 640 + 200], 63);
  });
  pins.feed(monitor);
  EXPECT_EQ(monitor.frames(), 1u);
}

TEST(VgaMonitor, ChecksumsAreZlibsOverColoursAndPins) {
  const Pins pins(2);
  VgaMonitor monitor(Raster(),
                     [&](const VgaFrame& frame) {
                       EXPECT_EQ(frame.image_crc, crc32(0, frame.colours.data(), 640 * 480));
                       EXPECT_EQ(frame.pins_crc,
                                 crc32(0, &pins.all()[frame.index * FrameClocks], FrameClocks));
                     },
                     {true, true});
  pins.feed(monitor);
  EXPECT_EQ(monitor.frames(), 2u);
}

TEST(VgaMonitor, LastChangeOfAClockWins) {
  VgaMonitor monitor(Raster(), nullptr);
  const Pins pins;
  for (int i = 0; i < FrameClocks; ++i) {
    monitor.change(i, 0x5a);
    monitor.change(i, pins.all()[i]);
  }
  monitor.advance(FrameClocks);
  EXPECT_EQ(monitor.frames(), 1u);
  EXPECT_THROW(monitor.advance(FrameClocks - 1), std::logic_error);
}

TEST(VgaMonitor, VsyncBeforeTheFirstHsyncEndIsFreeInTheFirstFrameOnly) {
  Pins first(2);
  first.flip(Vsync, -273, 0, 223, 0);
  EXPECT_EQ(first.verdict(), "good");
  Pins second(2);
  second.flip(Vsync, -273, 0, 223, 1);
  EXPECT_EQ(second.verdict(),
            "frame 1, line -273, clock 0: vsync is 1, must be 0 (sync pulse, which is line 250 "
            "clock 224 up to line -273 clock 224)");
}

struct Fault {
  const char* name;
  int mask, y, first, last;  // pins flipped in these clocks
  const char* verdict;       // how it starts
};
std::ostream& operator<<(std::ostream& out, const Fault& fault) { return out << fault.name; }

class VgaMonitorFaults : public testing::TestWithParam<Fault> {};

TEST_P(VgaMonitorFaults, IsRefusedAtTheRightPlace) {
  const Fault& fault = GetParam();
  Pins pins;
  pins.flip(fault.mask, fault.y, fault.first, fault.last);
  EXPECT_EQ(pins.verdict().substr(0, std::string(fault.verdict).size()), fault.verdict);
}

const Fault faults[] = {
    {"HsyncEarly", Hsync, -17, 31, 31,
     "frame 0, line -17, clock 31: hsync is 0, must be 1 (front porch, clocks 0..31)"},
    {"HsyncLate", Hsync, -17, 32, 32,
     "frame 0, line -17, clock 32: hsync is 1, must be 0 (sync pulse, clocks 32..223)"},
    {"HsyncTooShort", Hsync, 100, 223, 223,
     "frame 0, line 100, clock 223: hsync is 1, must be 0 (sync pulse, clocks 32..223)"},
    {"HsyncTooLong", Hsync, 100, 224, 224,
     "frame 0, line 100, clock 224: hsync is 0, must be 1 (back porch, clocks 224..319)"},
    {"HsyncBroken", Hsync, 251, 120, 121,
     "frame 0, line 251, clock 120: hsync is 1, must be 0 (sync pulse, clocks 32..223)"},
    {"HsyncMissing", Hsync, 0, 32, 223, "frame 0, line 0, clock 32: hsync is 1, must be 0"},
    {"HsyncInverted", Hsync, -273, 0, 1599, "frame 0, line -273, clock 0: hsync is 0, must be 1"},
    {"HsyncInPicture", Hsync, 7, 900, 900,
     "frame 0, line 7, clock 900: hsync is 0, must be 1 (visible columns, clocks 320..1599)"},
    {"HsyncInLastClock", Hsync, 251, 1599, 1599, "frame 0, line 251, clock 1599: hsync is 0"},
    {"VsyncEarly", Vsync, 250, 223, 223, "frame 0, line 250, clock 223: vsync is 0, must be 1"},
    {"VsyncALineEarly", Vsync, 249, 224, 1599, "frame 0, line 249, clock 224: vsync is 0"},
    {"VsyncLate", Vsync, 250, 224, 224, "frame 0, line 250, clock 224: vsync is 1, must be 0"},
    {"VsyncTooShort", Vsync, 251, 1599, 1599, "frame 0, line 251, clock 1599: vsync is 1"},
    {"VsyncTooLong", Vsync, -273, 224, 224,
     "frame 0, line -273, clock 224: vsync is 0, must be 1 (outside the pulse, which is line 250"},
    {"VsyncInPicture", Vsync, 0, 1000, 1000, "frame 0, line 0, clock 1000: vsync is 0, must be 1"},
    {"ColourInFrontPorch", 0x01, 3, 0, 0,
     "frame 0, line 3, clock 0: red, green, blue are 2, 0, 0, must be 0, 0, 0 (front porch"},
    {"ColourInSync", 0x40, 3, 100, 100,
     "frame 0, line 3, clock 100: red, green, blue are 0, 0, 1, must be 0, 0, 0 (sync pulse"},
    {"ColourInBackPorch", 0x02, 3, 319, 319,
     "frame 0, line 3, clock 319: red, green, blue are 0, 2, 0, must be 0, 0, 0 (back porch"},
    {"ColourAbovePicture", 0x10, -241, 1599, 1599,
     "frame 0, line -241, clock 1599: red, green, blue are 1, 0, 0, must be 0, 0, 0 (line -241 is "
     "not visible)"},
    {"ColourBelowPicture", 0x10, 240, 320, 320, "frame 0, line 240, clock 320: red, green, blue"}};
INSTANTIATE_TEST_SUITE_P(Pins, VgaMonitorFaults, testing::ValuesIn(faults),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(VgaMonitor, ToleratedFaultsAreCountedAndTheFrameIsHandedOn) {
  Pins pins(2);
  pins.flip(0x20, 240, 400, 409, 0);
  pins.flip(0x20, 240, 400, 409, 1);
  pins.flip(Hsync, 100, 223, 223, 1);
  VgaFaults faults;
  int frames = 0;
  VgaMonitor monitor(
      Raster(),
      [&](const VgaFrame& frame) {
        ++frames;
        for (int x = 0; x < 640; ++x) ASSERT_EQ(frame.colours[x], picture(x, 0));
      },
      {}, &faults);
  pins.feed(monitor);
  EXPECT_EQ(frames, 2);
  EXPECT_EQ(faults.colour_clocks, 20u);
  EXPECT_EQ(faults.sync_clocks, 1u);
  EXPECT_EQ(faults.first_colour.find("frame 0, line 240, clock 400: red, green, blue are 0, 1, 0"),
            0u);
  EXPECT_EQ(faults.first_sync.find("frame 1, line 100, clock 223: hsync is 1, must be 0"), 0u);
}

TEST(VgaMonitor, LostSyncsAreNotTolerated) {
  VgaFaults faults;
  VgaMonitor monitor(Raster(), nullptr, {}, &faults);
  EXPECT_THROW(monitor.advance(FrameClocks), SyncError);
}

TEST(VgaMonitor, DeadPinsAreRefused) {
  VgaMonitor monitor(Raster(), nullptr);
  monitor.advance(FrameClocks - 1);
  EXPECT_THROW(monitor.advance(FrameClocks), SyncError);
}

TEST(VgaMonitor, InvertedVsyncIsRefused) {
  Pins pins;
  for (int y = -273; y <= 251; ++y) pins.flip(Vsync, y, 0, 1599);
  EXPECT_EQ(pins.verdict().find("frame 0, line -273, clock 224: vsync is 0, must be 1"), 0u);
}

TEST(VgaMonitor, SyncsMayBePositive) {
  Raster raster;
  raster.hsync_pulse = raster.vsync_pulse = true;
  Pins pins(2);
  EXPECT_EQ(pins.verdict(raster),
            "frame 0, line -273, clock 0: hsync is 1, must be 0 (front porch, "
            "clocks 0..31)");
  for (int frame = 0; frame < 2; ++frame)
    for (int y = -273; y <= 251; ++y) pins.flip(Hsync | Vsync, y, 0, 1599, frame);
  EXPECT_EQ(pins.verdict(raster), "good");
  pins.flip(Vsync, 9, 5, 5, 1);
  EXPECT_EQ(pins.verdict(raster).find("frame 1, line 9, clock 5: vsync is 1, must be 0 (outside"),
            0u);
}

TEST(VgaMonitor, VsyncMayChangeAnywhereInItsLines) {
  for (const int clock : {0, 31, 100, 320, 1599}) {
    Raster raster;
    raster.vsync_at = clock;
    Pins pins(2);
    for (int frame = 0; frame < 2; ++frame)
      for (const int y : {250, -273}) {
        if (clock < 224) pins.flip(Vsync, y, clock, 223, frame);
        else pins.flip(Vsync, y, 224, clock - 1, frame);
      }
    EXPECT_EQ(pins.verdict(raster), "good") << clock;
    pins.flip(Vsync, 250, clock, clock, 1);
    EXPECT_EQ(pins.verdict(raster).substr(0, 17), "frame 1, line 250") << clock;
  }
}

TEST(VgaMonitor, SyncsMayComeEarlierThanThePicture) {
  for (const auto& [clocks, vsync_at] : {std::pair(-2, 0), {2, 1}, {2, 224}, {-2, 1599}}) {
    Raster raster;
    raster.vsync_at = vsync_at;
    raster.advance_syncs(clocks);
    Pins pins(2);
    for (int frame = 0; frame < 2; ++frame)
      for (int y = -273; y <= 251; ++y)
        for (int c = 0; c < LineClocks; ++c) {
          const int in_line = c + clocks;
          const int in_frame = (y + 273) * LineClocks + in_line + FrameClocks;
          const bool hsync = in_line < 32 || in_line >= 224;
          const bool vsync = (in_frame - 523 * LineClocks - vsync_at) % FrameClocks >= 3200;
          pins.at(y, c, frame) =
              (pins.at(y, c, frame) & ~(Hsync | Vsync)) | (hsync ? Hsync : 0) | (vsync ? Vsync : 0);
        }
    EXPECT_EQ(pins.verdict(raster), "good") << clocks << " " << vsync_at;
  }
}

TEST(VgaMonitor, FollowsEveryRaster) {
  for (int setting = 0; setting < 8 * 8; ++setting) {
    const Raster raster(setting / 8 + 1, setting % 8);
    VgaMonitor monitor(raster, [&](const VgaFrame& frame) {
      for (int x = 0; x < 640; ++x) ASSERT_EQ(frame.colours[x], picture(x, 0));
    });
    std::uint64_t clock = 0;
    bool vsync = false;
    for (int y = -273; y <= 251; ++y)
      for (int c = 0; c < raster.line_clocks(); ++c, ++clock) {
        const RasterClock& at = raster.clocks[c];
        if (at.position == -368 && (c == 0 || raster.clocks[c - 1].position != -368))
          vsync = y < 250;
        const bool visible = at.position >= -320 && y >= -240 && y < 240;
        // The colour is right in the pixel's last clock only.
        const int colour = !visible ? 0 : at.last ? picture(at.position + 320, y + 240) : 62;
        if (c % 4 == 0 || visible || at.position < -320)
          monitor.change(clock,
                         static_cast<std::uint8_t>((at.hsync ? Hsync : 0) | (vsync ? Vsync : 0) |
                                                   pins_of_colour(colour)));
      }
    monitor.advance(clock);
    EXPECT_EQ(monitor.frames(), 1u) << "setting " << setting;
  }
}

}  // namespace
}  // namespace racebeam
