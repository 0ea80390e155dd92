// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/silicon_plan.h"

#include <utility>

namespace racebeam {

SiliconPlan::SiliconPlan(const Silicon& silicon,
                         std::function<std::optional<UnitSilicon>(const std::string&)> stored)
    : silicon_(silicon), stored_(std::move(stored)) {}

void SiliconPlan::want(const knob_values& k) try {
  for (UnitParameters& unit : silicon_.units_of(k)) {
    ++without_sharing_;
    const auto [at, fresh] = by_hash_.try_emplace(unit.hash);
    if (!fresh) continue;
    at->second.silicon = stored_(unit.hash);
    units_.push_back(std::move(unit));
  }
} catch (const NoSilicon&) {
}

std::vector<UnitParameters> SiliconPlan::missing() const {
  std::vector<UnitParameters> missing;
  for (const UnitParameters& unit : units_) {
    const UnitOutcome& outcome = by_hash_.at(unit.hash);
    if (!outcome.silicon && outcome.fault.empty()) missing.push_back(unit);
  }
  return missing;
}

void SiliconPlan::put(const UnitParameters& unit, const UnitOutcome& outcome) {
  by_hash_.at(unit.hash) = outcome;
}

PointSilicon SiliconPlan::of(const knob_values& k) const try {
  PointSilicon sum;
  for (const UnitParameters& unit : silicon_.units_of(k)) {
    const auto at = by_hash_.find(unit.hash);
    if (at == by_hash_.end() || (!at->second.silicon && at->second.fault.empty()))
      return {0, 0, unit.text() + " is not synthesised yet"};
    if (!at->second.silicon) return {0, 0, at->second.fault};
    sum.flip_flops += at->second.silicon->flip_flops;
    sum.cells += at->second.silicon->cells;
  }
  return sum;
} catch (const NoSilicon& reason) {
  return {0, 0, reason.what()};
}

}  // namespace racebeam
