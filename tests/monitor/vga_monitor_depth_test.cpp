// The monitor on a converter of more than two bits a colour.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <zlib.h>

#include <vector>

#include "tb/monitor/vga_monitor.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

class ConverterMonitor : public testing::TestWithParam<int> {
 protected:
  const int bits = GetParam();
  const VgaPinout pinout = converter_pinout(bits);
  const Raster raster{1};

  /// Of a visible pixel: all bits are used somewhere.
  std::uint32_t colour(int column, int row) const {
    return static_cast<std::uint32_t>(column * 2654435761u + row * 40503u) & pinout.colours;
  }
  /// The pins in a clock of the frame.
  std::uint32_t pins(int at) const {
    const int y = raster.first_line + at / raster.line_clocks(), clock = at % raster.line_clocks();
    const RasterClock& one = raster.clocks[static_cast<std::size_t>(clock)];
    const bool vsync = raster.vsync(clock < raster.vsync_at ? y - 1 : y);
    const bool seen = raster.visible_line(y) && clock >= raster.active_begin;
    return (seen ? colour(one.position + raster.columns / 2, y - raster.first_visible_line) : 0) |
           static_cast<std::uint32_t>(one.hsync) << pinout.hsync |
           static_cast<std::uint32_t>(vsync) << pinout.vsync;
  }
  /// A frame, in which the pins of one clock are turned over.
  VgaFrame show(int at = -1, std::uint32_t turned = 0) const {
    VgaFrame shown;
    VgaMonitor monitor(
        raster, [&](const VgaFrame& frame) { shown = frame; }, {true, true}, nullptr, pinout);
    for (int clock = 0; clock < raster.frame_clocks(); ++clock)
      monitor.change(static_cast<std::uint64_t>(clock), pins(clock) ^ (clock == at ? turned : 0));
    monitor.advance(static_cast<std::uint64_t>(raster.frame_clocks()));
    return shown;
  }
  std::string fault(int at, std::uint32_t turned) const {
    try {
      show(at, turned);
    } catch (const SyncError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_P(ConverterMonitor, TakesEveryPixel) {
  const VgaFrame frame = show();
  EXPECT_EQ(frame.bits, bits);
  ASSERT_TRUE(frame.whole());
  for (int row = 0; row < frame.height; ++row)
    for (int column = 0; column < frame.width; ++column)
      ASSERT_EQ(frame.colour(static_cast<std::size_t>(row * frame.width + column)),
                colour(column, row))
          << column << ", " << row;
}

TEST_P(ConverterMonitor, SumsAllPins) {
  std::vector<std::uint8_t> bytes;
  for (int clock = 0; clock < raster.frame_clocks(); ++clock)
    for (int n = 0; n < 4; ++n) bytes.push_back(static_cast<std::uint8_t>(pins(clock) >> 8 * n));
  EXPECT_EQ(show().pins_crc, crc32(0, bytes.data(), static_cast<uInt>(bytes.size())));
}

TEST_P(ConverterMonitor, SeesColourWhereNoneMayBe) {
  const std::uint32_t red = (1u << bits) - 1;
  EXPECT_THAT(fault(3, red << 2 * bits), HasSubstr("clock 3: red, green, blue are " +
                                                   std::to_string(red) + ", 0, 0, must be"));
}

TEST_P(ConverterMonitor, SeesWrongSyncs) {
  const int at = 100 * raster.line_clocks() + raster.sync_begin;
  EXPECT_THAT(fault(at, 1u << pinout.hsync), HasSubstr("hsync is"));
  EXPECT_THAT(fault(at, 1u << pinout.vsync), HasSubstr("vsync is"));
}

INSTANTIATE_TEST_SUITE_P(Bits, ConverterMonitor, testing::Values(5, 8, 10));

}  // namespace
}  // namespace racebeam
