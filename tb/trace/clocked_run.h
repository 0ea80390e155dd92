// ClockedRun: whatever runs by clocks and has signals that a waveform can show.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "tb/trace/chip_signals.h"
#include "tb/trace/trace_axis.h"

namespace racebeam {

class ClockedRun {
 public:
  virtual ~ClockedRun() = default;

  virtual const TraceAxis& raster() const = 0;
  virtual int period_ps() const = 0;
  /// All signals; `registers`: these will be read too. They can be read as long as the run lives.
  virtual std::vector<ChipSignal> signals(bool registers) = 0;
  /// What an overview of a long window leaves out, for a message.
  virtual const char* left_out() const = 0;

  /// Simulates up to that clock: its ordinal, 0 is the first of frame 0. False: the user wants to
  /// stop, and it stands at the end of a line.
  virtual bool go_to(std::int64_t clock) = 0;
  /// Ordinal of the clock it stands in.
  virtual std::int64_t clock() const = 0;
  /// Calls `look` after every line that go_to() passes, and at its end, with the clock() there; an
  /// empty one ends that.
  void each_line(std::function<void(std::int64_t)> look) { each_line_ = std::move(look); }
  /// Calls `look` with the ordinal of every clock from here on, its wires settled; an empty one
  /// ends that.
  virtual void each_clock(std::function<void(std::int64_t)> look) = 0;
  /// Lets `look` see the clock in which the run stands.
  virtual void settle() = 0;

 protected:
  void line_done() const {
    if (each_line_) each_line_(clock());
  }

 private:
  std::function<void(std::int64_t)> each_line_;
};

}  // namespace racebeam
