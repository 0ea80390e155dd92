// EventWatch: runs the chip until something happens, and has the clocks around it written.
//
// A condition, the first difference of a unit in lockstep, Ctrl-C, a crash.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "tb/trace/condition.h"
#include "tb/trace/flight_recorder.h"
#include "tb/trace/trace_run.h"

namespace racebeam {

struct EventWatch {
  Condition* condition;  ///< or nullptr
  std::int64_t keep;     ///< clocks up to a crash or Ctrl-C; around() asks for no more before it
  /// The clocks to be written when something happens in the first of them.
  std::function<TraceWindow(const TracePoint&)> around;
  /// Writes the window of a run that stands before it; returns the exit code.
  std::function<int(TraceRun&, const TraceWindow&)> write;

  /// Watches the clocks `first` to `last` of a run that stands before them, and says what happened.
  /// Returns the exit code; nothing: nothing happened. Throws RtlError after a crash of the RTL.
  std::optional<int> run(TraceRun& run, std::int64_t first, std::int64_t last) const;

 private:
  FlightEvent happened(const TraceRun& run, FlightEvent::Kind kind, std::int64_t clock,
                       int detail = 0, int port = 0) const;
  FlightEvent stopped(FlightEvent::Kind kind, std::int64_t last_clock, int detail = 0) const;
  int replayed(TraceRun& copy, const FlightEvent& event) const;
};

}  // namespace racebeam
