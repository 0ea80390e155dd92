// Finds the frames of a chip whose counters start anywhere, by its sync pulses.
//
// As a screen does: it measures period, place and polarity of both syncs and where the picture
// stands between them. What it finds is the raster by which VgaMonitor then checks every clock.
// Only 640x480 at 60 Hz is known. Lines that the speed pins of this project's chip shorten are
// known by their length. Plain C++.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tb/pin_change.h"
#include "tb/raster.h"

namespace racebeam {

struct FoundFrames {
  Raster raster;
  std::uint64_t first = 0;  ///< clock 0 of the first whole frame
  /// Clocks by which the picture comes later after hsync than the mode says; negative: earlier.
  /// Chips that register only one of both have 1 or -1.
  int picture_late = 0;
};

/// `changes` are those of the pins before `clocks`, from reset on. Nothing found: it needs more
/// clocks, up to 3 frames. Throws SyncError if there are no pulses then, or not those of the mode.
std::optional<FoundFrames> find_frames(const std::vector<PinChange>& changes, std::uint64_t clocks,
                                       int clocks_per_pixel);

}  // namespace racebeam
