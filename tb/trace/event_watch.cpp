// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/event_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <vector>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/trace/chip_signals.h"
#include "tb/trace/line_progress.h"

namespace racebeam {

namespace {

std::string place_of(std::int64_t clock, const TraceAxis& raster) {
  return point_text(point_at(clock, raster), raster);
}

/// The first differences of the units in lockstep, by the clocks of a run.
class Differences {
 public:
  explicit Differences(const TraceRun& run, const std::vector<const Lockstep*>& units)
      : units_(units) {
    for (const Lockstep* unit : units)
      epochs_.push_back(run.clock() - static_cast<std::int64_t>(unit->clocks()));
  }

  struct First {
    std::int64_t clock;
    std::size_t unit;  ///< its number
    const LockstepDifference* what;
  };
  /// The earliest one so far.
  std::optional<First> first() const {
    std::optional<First> earliest;
    for (std::size_t n = 0; n < units_.size(); ++n) {
      const auto& found = units_[n]->first();
      if (!found) continue;
      const std::int64_t clock = epochs_[n] + static_cast<std::int64_t>(found->clock);
      if (!earliest || clock < earliest->clock) earliest = {clock, n, &*found};
    }
    return earliest;
  }

 private:
  const std::vector<const Lockstep*> units_;
  std::vector<std::int64_t> epochs_;
};

}  // namespace

FlightEvent EventWatch::happened(const TraceRun& run, FlightEvent::Kind kind, std::int64_t clock,
                                 int detail, int port) const {
  const TraceAxis& raster = run.raster();
  const TraceWindow window = around(point_at(clock, raster));
  return {kind, clock, window.from.ordinal(raster), window.to.ordinal(raster), detail, port};
}

FlightEvent EventWatch::stopped(FlightEvent::Kind kind, std::int64_t last_clock, int detail) const {
  return {kind, last_clock, last_clock - keep + 1, last_clock, detail};
}

// In a copy.
int EventWatch::replayed(TraceRun& copy, const FlightEvent& event) const {
  const TraceAxis& raster = copy.raster();
  copy.each_clock({});
  if (event.kind == FlightEvent::Crash)
    tell(fmt::format("crashed after {}{}", place_of(event.clock, raster),
                     event.detail == 0 ? "" : std::string(": ") + strsignal(event.detail)));
  const std::int64_t from = std::max(event.from, copy.clock());
  TraceWindow window{
      point_at(from, raster), point_at(event.to, raster), point_at(event.clock, raster), {}};
  if (event.kind == FlightEvent::Mismatch) {
    const Lockstep& unit = *copy.bench().locksteps().at(static_cast<std::size_t>(event.detail));
    window.differs = DifferingPort{scope_of_unit(unit.unit()), unit.output(event.port)};
  }
  return write(copy, window);
}

std::optional<int> EventWatch::run(TraceRun& run, std::int64_t first, std::int64_t last) const {
  const TraceAxis& raster = run.raster();
  const int line = raster.line_clocks();
  FlightRecorder recorder(keep, [&](const FlightEvent& event) { return replayed(run, event); });
  recorder.pass(run.clock());
  LineProgress progress(run, last, [] { return std::string(); });
  recorder.catch_crashes([&run] { return run.kernel_clock() - 1; });
  try {
    bool going = run.go_to(first);
    run.bench().forget_differences();
    const Differences differences(run, run.bench().locksteps());
    std::optional<std::int64_t> held;
    if (condition)
      run.each_clock([&](std::int64_t clock) {
        if (!held && condition->holds(clock)) held = clock;
      });
    while (run.clock() <= last) {
      going = going && run.go_to(std::min((run.clock() / line + 1) * line, last + 1));
      const auto found = differences.first();
      if (found || held || !going) progress.end();
      if (found && !(held && *held < found->clock)) {
        tell(fmt::format("{}.{} differs in {}: the RTL has {:#x}, the model {:#x}",
                         found->what->unit, found->what->port, place_of(found->clock, raster),
                         found->what->got, found->what->expected));
        const int code =
            recorder.replay(happened(run, FlightEvent::Mismatch, found->clock,
                                     static_cast<int>(found->unit), found->what->output));
        return code == ExitGood ? static_cast<int>(ExitDifference) : code;
      }
      if (held) {
        tell("--when holds in " + place_of(*held, raster));
        return recorder.replay(happened(run, FlightEvent::Condition, *held));
      }
      if (!going) {
        tell("stopped after " + place_of(run.clock() - 1, raster));
        recorder.replay(stopped(FlightEvent::Interrupt, run.clock() - 1));
        return ExitInterrupted;
      }
      recorder.pass(run.clock());
    }
  } catch (const RtlError&) {
    progress.end();
    recorder.replay(stopped(FlightEvent::Crash, run.kernel_clock() - 1));
    throw;
  }
  return std::nullopt;
}

}  // namespace racebeam
