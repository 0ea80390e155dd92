// Video modes by name: the timings that screens know.
//
// From VESA's "Monitor Timings" (DMT 1.13), CEA-861 for 720 and 1080 lines, and IBM's VGA for the
// 449-line modes. Plain C++.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

struct VideoMode {
  int columns, rows;
  int hertz;  ///< frames a second, rounded
  double pixel_mhz;
  int front, sync, back;          ///< pixels around the columns
  int below, vsync_lines, above;  ///< lines around the rows
  bool hsync_positive, vsync_positive;

  int line_pixels() const { return columns + front + sync + back; }
  int lines() const { return rows + below + vsync_lines + above; }
  /// "800x600 at 60 Hz"
  std::string name() const;
};

const std::vector<VideoMode>& video_modes();

/// What was measured at the pins.
struct MeasuredSyncs {
  int line_clocks, hsync_clocks, lines;
  bool hsync_positive, vsync_positive;
  double clock_hz;  ///< 0: not known
};

/// The mode that a screen would take them for; nullptr: none of the table. The lines must be as
/// many. Its pixels need not be whole clocks if the share of the hsync pulse or the line rate is
/// near that of the mode; of several, polarities decide.
const VideoMode* find_video_mode(const MeasuredSyncs& syncs);

}  // namespace racebeam
