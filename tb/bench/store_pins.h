// The screen's pins of a chip with a frame store, as VgaMonitor takes those of a converter of
// DacBits.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/store/store_knobs.h"
#include "tb/monitor/vga_monitor.h"

namespace racebeam {

constexpr VgaPinout StorePinout = converter_pinout(DacBits);

constexpr std::uint32_t store_pins(int red, int green, int blue, bool hsync_n, bool vsync_n) {
  return std::uint32_t{vsync_n} << StorePinout.vsync | std::uint32_t{hsync_n} << StorePinout.hsync |
         static_cast<std::uint32_t>(red << 2 * DacBits | green << DacBits | blue);
}

/// CRC-32 of the pins in a frame of the raster in which the frame store holds these words, by
/// address; computed without the chip's raster.
std::uint32_t store_pins_crc(const std::vector<std::uint64_t>& words, const store_knobs& k,
                             int clocks_per_pixel);

/// CRC-32 of a picture's colours.
std::uint32_t image_crc(const PackedPicture& picture);

}  // namespace racebeam
