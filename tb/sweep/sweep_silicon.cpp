// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_silicon.h"

#include <fmt/format.h>

#include <algorithm>

#include "tb/base/console.h"
#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/sweep/interval_text.h"

namespace racebeam {

namespace {

std::string fault_note(const UnitParameters& unit) { return "no silicon of " + unit.hash; }

}  // namespace

SweepSilicon::SweepSilicon(const SweepPlan& plan, Store* store, bool fresh)
    : plan_(plan), store_(store), fresh_(fresh) {
  if (!plan.file.measure.silicon) return;
  try {
    silicon_.emplace(plan.scenes.front().show.engine());
  } catch (const MissingTool& error) {
    if (needed()) throw;
    tell(fmt::format("no figures of silicon: {}", error.what()));
    return;
  }
  syntheses_.emplace(*silicon_, [this](const std::string& hash) -> std::optional<UnitSilicon> {
    if (!store_) return {};
    return store_->units.find(hash);
  });
  want();
}

void SweepSilicon::want() {
  for (; wanted_ < plan_.points.size(); ++wanted_)
    syntheses_->want(plan_.points[wanted_].k.front());
  if (!store_ || fresh_) return;
  std::size_t faults = 0;
  for (const UnitParameters& unit : syntheses_->missing())
    if (const std::string fault = store_->notes.find(fault_note(unit)); !fault.empty()) {
      syntheses_->put(unit, {{}, fault});
      ++faults;
    }
  if (faults > 0) tell(counted(faults, "unit") + " that yosys has failed on: --fresh tries again");
}

bool SweepSilicon::needed() const {
  const auto& goals = plan_.file.goals;
  return std::any_of(goals.begin(), goals.end(), [](const Goal& goal) {
    return figure_named(goal.figure)->measure() == std::string("silicon");
  });
}

std::string SweepSilicon::plan_text() const {
  if (!syntheses_) return "";
  const auto units = static_cast<long long>(syntheses_->missing().size());
  return fmt::format("; silicon: {} unit {} (of {} without sharing)", grouped(units),
                     units == 1 ? "synthesis" : "syntheses",
                     grouped(syntheses_->without_sharing()));
}

void SweepSilicon::measure(SweepState& state, Measurer& measurer, int jobs) {
  if (!syntheses_) return;
  want();
  SynthesisPlan how;
  how.jobs = jobs;
  synthesise(syntheses_->missing(), how,
             [&](const UnitParameters& unit, const UnitOutcome& outcome) {
               if (outcome.silicon) store_->units.put(*outcome.silicon);
               else store_->notes.put(fault_note(unit), outcome.fault);
               syntheses_->put(unit, outcome);
             });
  for (; measured_ < plan_.points.size(); ++measured_) {
    const auto point = static_cast<int>(measured_);
    const PlannedPoint& of = plan_.points[measured_];
    const PointSilicon silicon = syntheses_->of(of.k.front());
    if (silicon.fault.empty()) {
      state.set_exact(point, "flip_flops", static_cast<double>(silicon.flip_flops));
      state.set_exact(point, "cells", static_cast<double>(silicon.cells));
    } else if (needed()) {
      measurer.refuse(point, "no silicon: " + silicon.fault);
    } else {
      tell(fmt::format("no silicon of {}: {}", of.point.name, silicon.fault));
    }
  }
}

}  // namespace racebeam
