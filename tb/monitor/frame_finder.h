// Finds the frames of a chip whose counters start anywhere, by its sync pulses.
//
// As a screen does: it measures period, place and polarity of both syncs, takes the video mode that
// they are nearest to, and looks where the picture stands between them. What it finds is the raster
// by which VgaMonitor then checks every clock. Lines of 640x480 at 60 Hz that the speed pins of
// this project's chip shorten are known by their length. Of a mode that no table has, the visible
// part is estimated from where it is not black. Plain C++.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tb/monitor/pin_change.h"
#include "tb/monitor/raster.h"

namespace racebeam {

struct FoundFrames {
  Raster raster;
  std::string mode;         ///< "640x480 at 60 Hz", or "1056 clocks by 628 lines"
  bool known_mode = false;  ///< it has a name
  std::uint64_t first = 0;  ///< clock 0 of the first whole frame
  /// Clocks by which the picture comes later after hsync than the mode says; negative: earlier.
  /// Chips that register only one of both have 1 or -1.
  int picture_late = 0;
  double clock_hz = 0;         ///< as given, or what the mode needs
  bool clock_assumed = false;  ///< it was not given, or is far from what the mode needs
  double clocks_per_pixel = 1;

  double frames_per_second() const { return clock_hz / raster.frame_clocks(); }
};

/// `changes` are those of the pins before `clocks`, from reset on; `clock_hz` 0: not known;
/// `sure`: it holds, however little it fits. Nothing found: it needs more clocks. Throws SyncError
/// if there are no pulses after some frames, or none that make lines and frames.
std::optional<FoundFrames> find_frames(const std::vector<PinChange>& changes, std::uint64_t clocks,
                                       double clock_hz, bool sure = false);

}  // namespace racebeam
