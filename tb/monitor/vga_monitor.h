// VgaMonitor: a screen that sees the VGA pins and nothing else: the eight of the chip, or those of
// a converter of any depth.
//
// It is fed with changes of the pins, so its cost follows the picture, not the clock. When a frame
// is whole, every one of its clocks is checked: the place, width and polarity of both sync pulses,
// the porches, and black outside the visible pixels. Then the picture is handed on. Plain C++, no
// SystemC. Source: contract sections 4, 5.2, 5.3, 15.2.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tb/base/errors.h"
#include "tb/base/packed_picture.h"
#include "tb/monitor/raster.h"

namespace racebeam {

/// Pins of the TinyVGA connector; index 1 is the more significant bit of a colour.
enum VgaPin { PinR1 = 0, PinG1, PinB1, PinVsync, PinR0, PinG0, PinB0, PinHsync };
constexpr int ColourPins = 0x77;

/// r * 16 + g * 4 + b of the pins, each 0..3.
constexpr int colour_of_pins(int pins) {
  const auto bit = [pins](int pin) { return (pins >> pin) & 1; };
  return bit(PinR1) << 5 | bit(PinR0) << 4 | bit(PinG1) << 3 | bit(PinG0) << 2 | bit(PinB1) << 1 |
         bit(PinB0);
}

/// The colour pins of r * 16 + g * 4 + b; both syncs 0.
constexpr int pins_of_colour(int colour) {
  const auto bit = [colour](int from, int pin) { return ((colour >> from) & 1) << pin; };
  return bit(5, PinR1) | bit(4, PinR0) | bit(3, PinG1) | bit(2, PinG0) | bit(1, PinB1) |
         bit(0, PinB0);
}

/// Which of up to 32 pins is what.
struct VgaPinout {
  int bits;  ///< of each of the three colours
  int hsync, vsync;
  std::uint32_t colours;  ///< a mask of the pins of all three
  bool tiny = false;      ///< of TinyVGA; else red lies above green above blue, from pin 0 on

  constexpr std::uint32_t colour(std::uint32_t pins) const {
    return tiny ? static_cast<std::uint32_t>(colour_of_pins(static_cast<int>(pins)))
                : pins & colours;
  }
};
constexpr VgaPinout TinyVga{2, PinHsync, PinVsync, ColourPins, true};
/// Three colours of `bits` each, 1..10; above them hsync, then vsync.
constexpr VgaPinout converter_pinout(int bits) {
  return {bits, 3 * bits, 3 * bits + 1, (std::uint32_t{1} << 3 * bits) - 1};
}

/// A checked frame; or a picture from a frame store, which no monitor checks.
struct VgaFrame : PackedPicture {
  VgaFrame() : PackedPicture{VisibleColumns, VisibleRows, 2, {}} {}

  std::uint64_t index = 0;      ///< 0 is the first after reset
  std::uint32_t image_crc = 0;  ///< CRC-32 of colours; 0 unless asked for
  /// CRC-32 of the pins in each clock, a byte for each eight of them; 0 unless asked for.
  std::uint32_t pins_crc = 0;
};

/// Which check sums to compute.
struct VgaCrcs {
  bool image = false;
  bool pins = false;
};

/// What broke the mode in a run that went on nevertheless.
struct VgaFaults {
  std::uint64_t sync_clocks = 0;    ///< in which hsync or vsync was wrong
  std::uint64_t colour_clocks = 0;  ///< in which there was colour outside of the visible pixels
  std::string first_sync, first_colour;  ///< as SyncError says it

  bool any() const { return sync_clocks || colour_clocks; }
};

/// Clock 0 is the first clock of the front porch of line -273: the first after reset.
class VgaMonitor {
 public:
  using FrameCallback = std::function<void(const VgaFrame&)>;

  /// `on_frame` is called once for each whole frame; the frame it gets is reused afterwards. With
  /// `tolerated`, which must outlive the monitor, faults are counted there and the frame is handed
  /// on, unless the syncs are lost: wrong in a tenth of its clocks.
  VgaMonitor(const Raster& raster, FrameCallback on_frame, VgaCrcs crcs = {},
             VgaFaults* tolerated = nullptr, const VgaPinout& pinout = TinyVga);

  /// The pins have this value from `clock` on; of several calls for one clock the last wins. Every
  /// clock before it is known. The pins are 0 until told. Throws SyncError, and std::logic_error
  /// if the clock runs backwards.
  void change(std::uint64_t clock, std::uint32_t pins);

  /// Every clock before `clock` is known. Throws as change() does.
  void advance(std::uint64_t clock);

  /// Frames handed on.
  std::uint64_t frames() const { return good_frames_; }

 private:
  /// The pins' value from a clock of the frame up to the next run.
  struct Run {
    int clock;
    std::uint32_t pins;
  };
  /// A part of a line in which the pins are held to one rule.
  struct Span {
    int begin, end;  // clocks of the line
    bool hsync, vsync, check_vsync, black;
    const char* name;  // of the horizontal region
  };

  void finish_frame();
  void finish_line(int y, const Run*& run, const Run* end);
  void fill(std::uint8_t* row, int from, int to, std::uint32_t pins) const;
  void check(const Span& span, int y, int clock, int clocks, std::uint32_t pins);
  std::string fault(const Span& span, int y, int clock, std::uint32_t pins) const;
  std::uint32_t crc_of_pins() const;

  const Raster raster_;
  const FrameCallback on_frame_;
  const VgaCrcs crcs_;
  VgaFaults* const tolerated_;
  const VgaPinout pinout_;
  std::uint64_t frame_begin_ = 0;  // clock 0 of the frame being seen
  std::uint64_t now_ = 0;          // every clock before is known
  std::uint64_t good_frames_ = 0;
  std::vector<Run> runs_ = {{0, 0}};  // of the frame being seen; the first starts at its clock 0
  std::vector<Run> whole_;            // of the frame being checked
  VgaFrame frame_;
};

}  // namespace racebeam
