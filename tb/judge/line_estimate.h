// Estimates how hard a show is for the chip, without the chip: trace_4's walk through the decision
// tree, its steps counted and weighed with clocks.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/show/show.h"

namespace racebeam {

struct LineEstimate {
  /// Clocks from the tracer's start, which varies by some 15, to the end of the line: 1530 with the
  /// chip's knobs.
  static int budget(const knobs& k);

  int clocks = 0;     ///< that the tracer is busy, if the beam waits for it
  int intervals = 0;  ///< that the tracer cuts the line into
  int frame = 0, y = 0;
};

/// The worst line of a frame, among every `lines`-th. The ray pattern, which disturbs the tracer,
/// is not counted.
LineEstimate estimate_frame(const Show& show, int frame, const knobs& k, int lines = 1);

/// The worst of some lines of some frames. Brief peaks are missed, and of the knobs only those
/// count that golden_world() and the depth of the interval stack follow: see line_estimate.cpp.
LineEstimate estimate_worst_line(const Show& show, const knobs& k);

}  // namespace racebeam
