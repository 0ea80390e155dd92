// trace_4: the golden tracer that asks whole intervals, as the chip does, without the chip's
// limits.
//
// On the chip's integer rays: exact products, a stack without end, no beam to race. It walks the
// decision tree of contract 11.2 with both ends of an interval and bisects by the chip's rule, so
// that an edge which chatters switches at the same pixel. With the limits switched off the chip
// shows the same picture. It shares no decision code with trace_2 or with the chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/golden/golden_work.h"

namespace racebeam {

/// All pixels of line `y`. Adds to `work` if there is one, and then looks at every pixel of every
/// interval for switches: a question that is asked anew after a return counts once.
GoldenHits trace_4_line(const GoldenWorld& world, const GoldenRays& rays, int y,
                        IntervalWork* work = nullptr);

/// The same with the rooms.
std::array<GoldenEnd, VisibleColumns> trace_4_ends(const GoldenWorld& world, const GoldenRays& rays,
                                                   int y);

/// How often the tracer does what costs the chip clocks.
struct TraceWork {
  int questions = 0;  ///< asked at both ends of an interval
  int probes = 0;     ///< asked at one pixel between, to bisect
  int intervals = 0;  ///< emitted
};

/// The work of line `y` if the stack holds `entries` intervals and then loses the oldest.
TraceWork trace_4_work(const GoldenWorld& world, const GoldenRays& rays, int y, int entries);

/// The pixel in left..right-1 after which a decision is taken to switch. `same_as_left` is asked
/// for pixels between; the ends are known to differ. `rule` is a bisection_rule (contract 9.4 D,
/// E).
template <class Question>
int golden_switch(int left, int right, int rule, const Question& same_as_left) {
  bool agree = false;  // the last answer; it begins at the right end
  for (int width = right - left; width > 1; width = right - left) {
    int step = 1;  // closest power of two to half the width, ties up
    while (width >= 3 * step) step *= 2;
    if (rule == BisectionMidpoint) step = agree ? width / 2 : width - width / 2;
    if (rule == BisectionFloor)
      for (step = 1; 4 * step <= width;) step *= 2;
    const int probe = agree ? left + step : right - step;
    agree = same_as_left(probe);
    (agree ? left : right) = probe;
  }
  return left;
}

}  // namespace racebeam
