// chip_observer: who wants to see how the picture comes about, interval by interval.
//
// chip_lines calls it while it runs a line. Without one there is no cost: the loop is compiled
// twice.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// An interval that the FIFO took. Pixel i is shown in column i + 1; pixel 639 never.
struct taken_interval {
  int y;            ///< scan line, -273..251; visible ones are -240..239
  int clock;        ///< of the line, 0 is the first of the front porch; known from then on
  int first, last;  ///< pixels, 0..639
  int value;        ///< colour index, 0..3; checkered, the lower one of two
  int room, depth;  ///< room that the tracer is in, rooms entered on the way to it
  int face;         ///< axis of the wall hit; of an earlier hit if given up
  bool behind;      ///< the room is one behind an opening of that wall, which was missed or is not
                    ///< looked through any more
  bool given_up;    ///< no wall: the hurry rule ended it for a starving beam
  int decisions;    ///< LEFT, RIGHT and BISECT ones of this line so far
};

class chip_observer {
 public:
  virtual ~chip_observer() = default;

  /// The tracer starts on line `y` in this clock: the camera has its rays.
  virtual void started(int y, int clock) = 0;
  /// From this clock of line `y` on the tracer is in another room, or in the line's first one,
  /// `depth` rooms entered on the way to it: by descending, by returning, or by a restart. Half way
  /// into a room it is in that room, as room_q says. Where the stack has run empty, the way back
  /// goes one room too far, perhaps to depth 15, in the clock before a restart. Not on line 251,
  /// where the navigator has the rooms.
  virtual void entered(int y, int clock, int room, int depth) = 0;
  /// The FIFO took an interval.
  virtual void interval(const taken_interval& taken) = 0;
  /// An underflow restart in this clock of line `y`: the tracer goes on from the top of the tree
  /// with the pixels `pixel`..639.
  virtual void restart(int y, int clock, int pixel) = 0;
  /// `count` columns of visible line `y` from `column` on show `colour`, r * 16 + g * 4 + b, when
  /// a monitor samples them: in clocks chip_lines::column_clock(column), ...
  virtual void shown(int y, int column, int count, int colour) = 0;
  /// Line `y` is over; decisions as of taken_interval.
  virtual void line_end(int y, int decisions) = 0;
};

}  // namespace racebeam
