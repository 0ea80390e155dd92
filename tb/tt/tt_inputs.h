// The inputs of a Tiny Tapeout tile, from its reset on and as they change in time.
//
// As a file they are comma-separated values:
//
//   frame,line,clock,ui,uio
//   reset,0,0,0,0          from the reset on
//   12,-240,0,0x05,0       from this clock of frame 12 on; the chip's logic sees it a clock later
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "tb/monitor/raster.h"

namespace racebeam {

/// ui_in and uio_in.
struct TilePins {
  std::uint8_t ui = 0, uio = 0;
  bool operator==(const TilePins& o) const { return ui == o.ui && uio == o.uio; }
  bool operator!=(const TilePins& o) const { return !(*this == o); }
};

/// From this clock of a frame on; frame 0 is the first whole one after reset.
struct TileInput {
  int frame, line, clock;
  TilePins pins;
  int row = 0;  ///< line of the file it came from; 0: none
  auto place() const { return std::tie(frame, line, clock); }
};

class TtInputs {
 public:
  explicit TtInputs(TilePins start = {}) : start_(start) {}

  /// Reads a file; `start` counts unless the file has a row `reset`. Throws UsageError that names
  /// file, line and column.
  static TtInputs read(const std::string& path, TilePins start);

  /// From the reset on.
  TilePins start() const { return start_; }
  /// In the order of time.
  const std::vector<TileInput>& changes() const { return changes_; }
  /// Clocks since clock 0 of frame 0 at which changes() come. Throws UsageError if one is at a
  /// line or clock that the frames do not have.
  std::vector<std::uint64_t> clocks(const Raster& raster) const;
  /// From here on they are others: what was to come at or behind that place is dropped.
  void change(const TileInput& input);

  /// The text of a file with all of them.
  std::string text() const;

 private:
  TilePins start_;
  std::vector<TileInput> changes_;
  std::string file_;
};

}  // namespace racebeam
