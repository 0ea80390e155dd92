// line_setting: what the tracer of a line is told, and what it counts.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/beam/decision_datapath_core.h"
#include "sc/beam/scene_program.h"
#include "sc/beam/sequencer.h"
#include "sc/beam/tlm/chip_observer.h"
#include "sc/beam/tlm/line_raster.h"

namespace racebeam {

/// The events of one line before line_done, and clocks of the line.
struct line_counts {
  int left = 0, right = 0, bisect = 0, adjust = 0, descents = 0, pushes = 0, returns = 0,
      return_clocks = 0, emits = 0, restarts = 0, give_ups = 0, stalls = 0, rooms = 0;
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

struct line_setting {
  const knobs& k;
  const line_raster& raster;
  const std::vector<room_row>& rooms;
  int room_mask;  ///< bits of a room's id that count
  int y;
  bool interlace;               ///< this line shows the previous camera position
  sequencer_outputs choice[2];  ///< while the tracer runs; [1] where dr2 asks for the pattern
  std::uint8_t colours[4];      ///< of the display indices, without the pattern
  std::uint8_t* row;            ///< pixels that show the pattern, if it may hold; else nullptr
  chip_observer* observer;
  std::uint64_t* depths;    ///< histogram of the interval stack's entries, 65 of them
  room_teller* rooms_told;  ///< to the observer, of this line
};

}  // namespace racebeam
