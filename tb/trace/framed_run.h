// FramedRun: a run that goes frame by frame and writes signals of its own into a VCD.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "tb/trace/trace_window.h"

namespace racebeam {

class FramedRun {
 public:
  virtual ~FramedRun() = default;

  /// Runs the frames of `window`, whole ones, until `stop` says so between two of them. Returns the
  /// clocks of the window that were written. To be called once.
  virtual std::int64_t run(const TraceWindow& window, const std::function<bool()>& stop) = 0;
};

}  // namespace racebeam
