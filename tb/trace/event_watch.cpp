// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/event_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <vector>

#include "tb/console.h"
#include "tb/errors.h"

namespace racebeam {

namespace {

std::string place_of(std::int64_t clock, const Raster& raster) {
  const TracePoint at = point_at(clock, raster);
  return fmt::format("frame {}, line {}, clock {}", at.frame, at.line, at.clock);
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
    const LockstepDifference* what;
  };
  /// The earliest one so far.
  std::optional<First> first() const {
    std::optional<First> earliest;
    for (std::size_t n = 0; n < units_.size(); ++n) {
      const auto& found = units_[n]->first();
      if (!found) continue;
      const std::int64_t clock = epochs_[n] + static_cast<std::int64_t>(found->clock);
      if (!earliest || clock < earliest->clock) earliest = {clock, &*found};
    }
    return earliest;
  }

 private:
  const std::vector<const Lockstep*> units_;
  std::vector<std::int64_t> epochs_;
};

}  // namespace

FlightEvent EventWatch::event(const TraceRun& run, FlightEvent::Kind kind, std::int64_t clock,
                              int detail) const {
  const Raster& raster = run.raster();
  if (kind == FlightEvent::Interrupt) return {kind, clock, clock - keep, clock, detail};
  const TraceWindow window = around(point_at(clock, raster));
  return {kind, clock, window.from.ordinal(raster), window.to.ordinal(raster), detail};
}

std::optional<int> EventWatch::run(TraceRun& run, std::int64_t first, std::int64_t last) const {
  const Raster& raster = run.raster();
  FlightRecorder recorder(keep, [&](const FlightEvent& what) {
    run.each_clock({});
    if (what.kind == FlightEvent::Crash)
      tell(fmt::format("crashed after {}: {}", place_of(what.clock, raster),
                       strsignal(what.detail)));
    const std::int64_t from = std::max(what.from, run.clock());
    const TracePoint event = point_at(what.clock, raster);
    return write(run, {point_at(from, raster), point_at(what.to, raster), event});
  });
  recorder.pass(run.clock());
  const Differences differences(run, run.bench().locksteps());
  recorder.catch_crashes([&run] { return run.kernel_clock() - 1; });
  bool going = run.go_to(first);
  std::optional<std::int64_t> held;
  if (condition)
    run.each_clock([&](std::int64_t clock) {
      if (!held && condition->holds(clock)) held = clock;
    });
  while (run.clock() <= last) {
    going = going && run.go_to(run.clock() + raster.line_clocks());
    if (held && *held <= last) {
      tell("--when holds in " + place_of(*held, raster));
      return recorder.replay(event(run, FlightEvent::Condition, *held));
    }
    if (const auto found = differences.first(); found && found->clock <= last) {
      tell(fmt::format("{}.{} differs in {}: the RTL has {:#x}, the model {:#x}", found->what->unit,
                       found->what->port, place_of(found->clock, raster), found->what->got,
                       found->what->expected));
      const int code = recorder.replay(event(run, FlightEvent::Mismatch, found->clock));
      return code == ExitGood ? static_cast<int>(ExitDifference) : code;
    }
    if (!going) {
      tell("stopped in " + place_of(run.clock(), raster));
      recorder.replay(event(run, FlightEvent::Interrupt, run.clock()));
      return ExitInterrupted;
    }
    recorder.pass(run.clock());
  }
  return std::nullopt;
}

}  // namespace racebeam
