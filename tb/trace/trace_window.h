// The window of a waveform: from one clock of the show to another.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "tb/bench/pixel_clocks.h"
#include "tb/trace/trace_axis.h"
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
/// "frame 7, line -3, clock 400"; "picture 7, clock 250000".
std::string point_text(const TracePoint& at, const TraceAxis& raster);
/// The same as `--from` takes it, of a line: "7:-3"; "7:250000".
std::string point_option(const TracePoint& at, const TraceAxis& raster);

/// Both ends are in it.
struct TraceWindow {
  TracePoint from, to;
  std::optional<TracePoint> mark{};        ///< what it lies around
  std::optional<DifferingPort> differs{};  ///< and what that is
};

/// A show of `frames` frames on a raster, or of pictures on their axis.
class TraceWindowReader {
 public:
  using Pixels = std::function<PixelClocks(int picture)>;

  /// `pixels`: of pictures only.
  TraceWindowReader(int frames, const TraceAxis& raster, Pixels pixels = {})
      : frames_(frames), raster_(raster), pixels_(std::move(pixels)) {}

  const TraceAxis& raster() const { return raster_; }

  /// "60:-240:800", as FRAME:LINE or FRAME:LINE:CLOCK. Without a clock `from` begins, and `to`
  /// ends, with the line. Of pictures "3:250000" or "3:@200,240", as PICTURE:CLOCK or PICTURE:@X,Y:
  /// the clock in which that pixel begins, or with `to` ends. Throws UsageError: no such form, out
  /// of range, `to` before `from`.
  TraceWindow window(const std::string& from, const std::string& to) const;
  /// Of pictures: `number` pixels from `from`, "3:@200,240", on. Throws UsageError.
  TraceWindow pixels(const std::string& from, long long number) const;
  /// Where a search begins, and ends, if nobody says; `from` as it was written.
  std::string first() const;
  std::string last(const std::string& from) const;

  /// Throws UsageError as window() does for an end that is given; an empty one is not.
  void check(const std::string& from, const std::string& to) const;

  /// The line of `point`, with `lines` before and after it as far as the show has them.
  TraceWindow around(const TracePoint& point, long long lines) const;
  /// `point` with so many clocks before and after it, as far as the show has them.
  TraceWindow around(const TracePoint& point, long long before, long long after) const;

 private:
  TracePoint point(const char* option, const std::string& text, int clock) const;
  TracePoint picture_point(const char* option, const std::string& text, bool ends) const;
  TracePoint in_picture(int picture, std::int64_t clock) const;
  const PixelClocks& clocks_of(int picture) const;

  const int frames_;
  const TraceAxis& raster_;
  const Pixels pixels_;
  mutable std::map<int, PixelClocks> known_;  // pictures that were drawn for their pixels
};

}  // namespace racebeam
