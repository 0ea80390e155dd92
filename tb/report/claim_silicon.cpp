// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/claim_silicon.h"

#include <algorithm>

#include "sc/beam/engine.h"
#include "tb/base/errors.h"
#include "tb/sweep/synthesis.h"

namespace racebeam {

ClaimSilicon::ClaimSilicon(UnitCache& cache) : cache_(cache) {
  try {
    silicon_.emplace(beam_engine());
  } catch (const MissingTool& error) {
    missing_ = error.what();
  }
}

std::vector<UnitParameters> ClaimSilicon::units_of(const SiliconFigure& figure,
                                                   const knob_values& k) const {
  std::vector<UnitParameters> units = silicon_->units_of(k);
  units.erase(std::remove_if(units.begin(), units.end(),
                             [&](const UnitParameters& unit) {
                               return !figure.unit.empty() && unit.unit != figure.unit;
                             }),
              units.end());
  return units;
}

void ClaimSilicon::want(const SiliconFigure& figure, const knob_values& k) {
  if (!silicon_) return;
  try {
    for (const UnitParameters& unit : units_of(figure, k))
      if (!cache_.find(unit.hash)) wanted_.emplace(unit.hash, unit);
  } catch (const NoSilicon&) {
    return;  // why() says it
  }
}

void ClaimSilicon::measure(int jobs) {
  std::vector<UnitParameters> units;
  for (const auto& [hash, unit] : wanted_) units.push_back(unit);
  SynthesisPlan how;
  how.jobs = jobs;
  synthesise(units, how, [&](const UnitParameters& unit, const UnitOutcome& outcome) {
    if (outcome.silicon) cache_.put(*outcome.silicon);
    else faults_[unit.hash] = outcome.fault;
  });
  wanted_.clear();
}

std::optional<double> ClaimSilicon::value(const SiliconFigure& figure, const knob_values& k) const {
  if (!why(figure, k).empty()) return {};
  std::int64_t sum = 0;
  for (const UnitParameters& unit : units_of(figure, k)) {
    const UnitSilicon of = *cache_.find(unit.hash);
    sum += figure.flip_flops ? of.flip_flops : of.cells;
  }
  return static_cast<double>(sum);
}

std::string ClaimSilicon::why(const SiliconFigure& figure, const knob_values& k) const {
  if (!silicon_) return missing_;
  try {
    for (const UnitParameters& unit : units_of(figure, k)) {
      if (const auto fault = faults_.find(unit.hash); fault != faults_.end()) return fault->second;
      if (!cache_.find(unit.hash)) return unit.text() + " has not been synthesised";
    }
  } catch (const NoSilicon& error) {
    return error.what();
  }
  return "";
}

}  // namespace racebeam
