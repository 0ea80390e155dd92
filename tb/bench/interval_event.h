// IntervalEvent: an interval that the tracer handed to the beam, and what it took.
//
// A plain record, so that any level of the simulation can tell of it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

struct IntervalEvent {
  /// In `clock`: the line ended before the tracer came here.
  static constexpr int Never = -1;

  int y;          ///< line, -240..239
  int from, to;   ///< pixels of the line, 0..639, both included; shown one column later
  int clock;      ///< of the line, from 0: the FIFO took it in this clock
  int decisions;  ///< since the interval before it in this line
  int depth;      ///< rooms entered
  int room;       ///< the last one entered
  int face;       ///< axis of the face hit, 0..2
  bool behind;    ///< the room is one behind an opening of that wall, the last one asked about
  bool wall;      ///< a wall was hit; else it was given up, as the beam was starving

  bool known() const { return clock != Never; }
  int length() const { return to - from + 1; }
};

}  // namespace racebeam
