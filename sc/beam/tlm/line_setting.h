// line_setting: what the tracer of a line is told, and what it counts.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "sc/beam/decision_datapath_core.h"
#include "sc/beam/scene_program.h"
#include "sc/beam/sequencer.h"
#include "sc/beam/tlm/chip_observer.h"
#include "sc/beam/tlm/line_beam.h"
#include "sc/beam/tlm/line_raster.h"

namespace racebeam {

/// The events of one line before line_done, and clocks of the line.
struct line_counts {
  int left = 0, right = 0, bisect = 0, adjust = 0, descents = 0, pushes = 0, returns = 0,
      return_clocks = 0, emits = 0, restarts = 0, give_ups = 0, stalls = 0, rooms = 0, merges = 0,
      sign_splits = 0, seen_starved = 0;
  int stack_needed = 0;
  int camera_clock = -1, first_emit = -1, done_clock = -1;
  int clocks = 0;  ///< of the tracer

  int decisions() const { return left + right + bisect; }
};

/// Tells an observer of the rooms of a line.
struct room_teller {
  int room = -1, depth = -1;  ///< told last

  void tell(chip_observer& observer, int y, int clock, const decision_datapath_core& place) {
    const int entered = place.rooms_entered();
    if (room == place.room_q && depth == entered) return;
    room = place.room_q;
    depth = entered;
    observer.entered(y, clock, room, depth);
  }
};

/// Counts the pixels first..last, which the FIFO takes in a clock of the line, by the clocks until
/// they are shown, each one column further right; those that come too late are not counted.
inline void add_slack(std::array<std::uint64_t, 65>& slack, const line_raster& raster, int clock,
                      int first, int last) {
  int column = std::max(first + 1, raster.columns_before[clock + 1]);
  const int end = std::min(last + 2, VisibleColumns);
  while (column < end) {
    const int bin = (raster.column_clock[column] - clock) / SlackBin;
    const int beyond = std::min(clock + SlackBin * (bin + 1), raster.size());
    const int next = std::min(raster.columns_before[beyond], end);
    bin_of(slack, bin) += next - column;
    column = next;
  }
}

struct line_setting {
  const knobs& k;
  const line_raster& raster;
  const std::vector<room_row>& rooms;
  int room_mask;  ///< bits of a room's id that count
  int y;
  bool interlace;               ///< this line shows the previous camera position
  sequencer_outputs choice[2];  ///< while the tracer runs; [1] where dr2 asks for the pattern
  shown_colours colours;        ///< without the pattern
  std::uint8_t* row;            ///< pixels that show the pattern, if it may hold; else nullptr
  chip_observer* observer;
  frame_stats& histograms;  ///< into which its histograms go up to line_done
  frame_stats& unseen;      ///< and then
  room_teller* rooms_told;  ///< to the observer, of this line
  bool apart;               ///< what the tracer does after line_done is not wanted
};

}  // namespace racebeam
