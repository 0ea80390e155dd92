// The window of a waveform: from one clock of the show to another.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "tb/monitor/raster.h"
#include "tb/wave/selection.h"

namespace racebeam {

/// A clock of a frame.
struct TracePoint {
  int frame, line, clock;  ///< line -273..251; clock 0 is the first of the front porch

  /// Clocks since the start of frame 0.
  std::int64_t ordinal(const Raster& raster) const {
    return static_cast<std::int64_t>(frame) * raster.frame_clocks() +
           static_cast<std::int64_t>(line - raster.first_line) * raster.line_clocks() + clock;
  }
  /// -160..639; 0..639 are the visible columns.
  int pixel(const Raster& raster) const {
    return raster.clocks[static_cast<std::size_t>(clock)].position + raster.columns / 2;
  }
};

/// The clock with this ordinal.
TracePoint point_at(std::int64_t ordinal, const Raster& raster);

/// Both ends are in it.
struct TraceWindow {
  TracePoint from, to;
  std::optional<TracePoint> mark{};        ///< what it lies around
  std::optional<DifferingPort> differs{};  ///< and what that is
};

/// A show of `frames` frames on a raster.
class TraceWindowReader {
 public:
  TraceWindowReader(int frames, const Raster& raster) : frames_(frames), raster_(raster) {}

  const Raster& raster() const { return raster_; }

  /// "60:-240:800", as FRAME:LINE or FRAME:LINE:CLOCK. Without a clock `from` begins, and `to`
  /// ends, with the line. Throws UsageError: no such form, out of range, `to` before `from`.
  TraceWindow window(const std::string& from, const std::string& to) const;

  /// Throws UsageError as window() does for an end that is given; an empty one is not.
  void check(const std::string& from, const std::string& to) const;

  /// The line of `point`, with `lines` before and after it as far as the show has them.
  TraceWindow around(const TracePoint& point, long long lines) const;
  /// `point` with so many clocks before and after it, as far as the show has them.
  TraceWindow around(const TracePoint& point, long long before, long long after) const;

 private:
  TracePoint point(const char* option, const std::string& text, int clock) const;

  const int frames_;
  const Raster& raster_;
};

}  // namespace racebeam
