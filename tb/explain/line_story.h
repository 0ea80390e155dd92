// LineStory: all that the tracer and the beam did in one visible line, as plain records.
//
// The tracer's clocks from its first one to line_done are cut into steps, and the steps into the
// intervals that they led to: no clock is left out, none is counted twice.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sc/base/constants.h"
#include "sc/base/fixed_point.h"
#include "tb/scene/scene_file.h"

namespace racebeam {

/// One clock of the tracer; or several in which it did nothing but wait for the FIFO.
struct TracerStep {
  int clock, clocks;  ///< first clock of the line, number of clocks
  int state;          ///< subdivider_state
  int first, last;    ///< the interval in hand, both included
  int idx2;           ///< pixel of the ray at the right end
  int room, depth, level;
  int face;       ///< axis of the face by which the room was entered
  bool y_first;   ///< in level 7: of x and y, y is met first
  bool second;    ///< a room change takes this clock too
  bool walks;     ///< LEFT only: the ray at the right end is still on its way there
  bool decision;  ///< a decision was taken; else answer and agrees mean nothing
  int answer;     ///< {sign z, sign y, sign x} at the top of the tree, else one bit
  bool agrees;    ///< RIGHT, BISECT: the answer is that of the left end
  bool descends;  ///< with this answer
  bool pushes;    ///< the right part, to be traced later
  bool finds_wall;
  bool offers;    ///< an interval to the FIFO
  bool emits;     ///< and the FIFO takes it
  bool climbs;    ///< towards the place of the youngest interval on the stack
  bool pops;      ///< that interval
  bool restarts;  ///< the stack is empty: from the top of the tree to the end of the line

  /// Pixel whose ray was asked.
  int asked() const { return state == 0 ? first : idx2; }
};

/// A room on the way of a ray, and the face by which it was entered.
struct RoomOnWay {
  int room;
  int axis;       ///< 0..2; not in the first one, where the camera is
  bool negative;  ///< towards negative coordinates
};

/// How an interval ended.
enum class IntervalEnd {
  Solid,    ///< a face without openings
  Missed,   ///< the wall around an opening
  TooDeep,  ///< a face behind which the tracer does not look: max_room_depth
  GivenUp,  ///< no wall: a starving beam takes short intervals as they are
  Never,    ///< the line ended before
};

/// An interval that the tracer handed to the beam; or the rest of a line that it never knew.
struct TracedInterval {
  int first, last;  ///< pixels 0..639; shown one column later
  IntervalEnd end;
  int clock;                   ///< of the line: the FIFO took it; -1: Never
  int value;                   ///< colour index that it took; checkered, the lower of two
  bool starving;               ///< index 0 whatever was hit
  int depth, level;            ///< of the tracer when it was offered
  std::vector<RoomOnWay> way;  ///< from the camera to the room whose face is hit
  int behind;                  ///< room behind the opening that was asked about last, or SolidRoom
  int axis;                    ///< of the face hit; -1 if none
  bool negative;               ///< hit towards negative coordinates
  std::size_t step_begin, step_end;

  bool known() const { return clock >= 0; }
  int length() const { return last - first + 1; }
};

/// A column of the line as a monitor sampled it.
struct ShownColumn {
  int clock;    ///< of the line
  int colour;   ///< r * 16 + g * 4 + b of the pins
  int display;  ///< index that the FIFO shows
  bool starving, pattern, inverse;
  int index;                   ///< after pattern and inversion
  int palette;                 ///< 0..2, or TablePalette
  std::array<int, 4> colours;  ///< of the palette
  int idx2;                    ///< pixel of the ray that the pattern shows ...
  vec3 ray;                    ///< ... and its direction
};

/// What was shown in a line and why.
struct LineStory {
  int frame, y;
  bool shading_b;         ///< by axis, side and line parity; else by axis
  int dithering;          ///< dithering_rule: checkered by the parity of column plus line
  int tracer_begin = -1;  ///< first clock of the tracer
  std::vector<TracerStep> steps;
  std::vector<TracedInterval> intervals;
  std::array<ShownColumn, VisibleColumns> columns{};

  /// The interval of a pixel, 0..639; nullptr in a line without tracing.
  const TracedInterval* interval_of(int pixel) const;
};

/// Sums over the steps of an interval.
struct StepTotals {
  int left = 0, right = 0, bisect = 0;  ///< decisions
  int walks = 0, room_changes = 0;      ///< clocks
  int returns = 0;                      ///< clocks of a return but those of waiting
  int waits = 0;                        ///< clocks in which the FIFO did not take the interval
  int pushes = 0, restarts = 0;

  int decisions() const { return left + right + bisect; }
  int clocks() const { return decisions() + walks + room_changes + returns + waits; }
};
StepTotals totals(const LineStory& story, const TracedInterval& interval);

}  // namespace racebeam
