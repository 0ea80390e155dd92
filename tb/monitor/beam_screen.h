// BeamScreen: a screen that draws while the beam moves, and finds its place by the pins' syncs.
//
// VgaMonitor checks whole frames; this one shows half a frame too, and looks at every clock. The
// old picture stays where the beam has not come yet, as on a tube. No syncs, no change of place:
// it free-runs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "tb/monitor/raster.h"

namespace racebeam {

class BeamScreen {
 public:
  /// Stands before the first clock of a frame until a sync tells better.
  explicit BeamScreen(const Raster& raster);

  /// Stands there again; the picture stays.
  void home() { y_ = raster_.first_line, clock_ = 0, started_ = false; }

  /// A whole picture of a frame, shown at once; the beam stands before the next.
  void show(std::vector<std::uint8_t> colours) {
    colours_ = std::move(colours);
    home();
  }

  /// The pins of the next clock.
  void clock(int uo);

  /// 640 x 480, or of another mode, row by row, r * 16 + g * 4 + b.
  const std::vector<std::uint8_t>& colours() const { return colours_; }
  /// Line -273..251 and clock of the line of the next clock.
  int y() const { return y_; }
  int clock_of_line() const { return clock_; }

 private:
  void find_place(int uo, int changed);

  const Raster raster_;
  std::vector<std::uint8_t> colours_;
  int y_, clock_ = 0;
  int uo_ = 0;
  bool started_ = false;
};

}  // namespace racebeam
