// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/claim_silicon.h"

#include <algorithm>

#include "sc/beam/engine.h"
#include "tb/base/errors.h"
#include "tb/sweep/synthesis.h"

namespace racebeam {

ClaimSilicon::ClaimSilicon(Store& store) : cache_(store.units), chips_(store.chips) {
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
  if (figure.what == SiliconFigure::LongestPath) return want_path(k);
  try {
    for (const UnitParameters& unit : units_of(figure, k))
      if (!cache_.find(unit.hash)) wanted_.emplace(unit.hash, unit);
  } catch (const NoSilicon&) {
    return;  // why() says it
  }
}

void ClaimSilicon::want_path(const knob_values& k) try {
  if (!technology_) technology_.emplace(*silicon_, StandardCells);
  const ChipWanted chip = technology_->chip_of(k);
  if (!chips_.find(chip.chip.hash)) wanted_chips_.emplace(chip.chip.hash, chip);
} catch (const MissingTool& error) {
  no_technology_ = error.what();
} catch (const NoSilicon&) {
  // why() says it
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
  std::vector<ChipWanted> chips;
  for (const auto& [hash, chip] : wanted_chips_) chips.push_back(chip);
  how.limit = ChipLimit;
  map_chips(chips, how, [&](const ChipWanted& chip, const ChipOutcome& outcome) {
    if (outcome.mapped) chips_.put(*outcome.mapped);
    else faults_[chip.chip.hash] = outcome.fault;
  });
  wanted_chips_.clear();
}

std::optional<double> ClaimSilicon::value(const SiliconFigure& figure, const knob_values& k) const {
  if (!why(figure, k).empty()) return {};
  if (figure.what == SiliconFigure::LongestPath)
    return chips_.find(technology_->chip_of(k).chip.hash)->ns;
  std::int64_t sum = 0;
  for (const UnitParameters& unit : units_of(figure, k)) {
    const UnitSilicon of = *cache_.find(unit.hash);
    sum += figure.what == SiliconFigure::FlipFlops ? of.flip_flops : of.cells;
  }
  return static_cast<double>(sum);
}

std::string ClaimSilicon::why(const SiliconFigure& figure, const knob_values& k) const {
  if (!silicon_) return missing_;
  try {
    if (figure.what == SiliconFigure::LongestPath) return why_no_path(k);
    for (const UnitParameters& unit : units_of(figure, k)) {
      if (const auto fault = faults_.find(unit.hash); fault != faults_.end()) return fault->second;
      if (!cache_.find(unit.hash)) return unit.text() + " has not been synthesised";
    }
  } catch (const NoSilicon& error) {
    return error.what();
  }
  return "";
}

std::string ClaimSilicon::why_no_path(const knob_values& k) const {
  if (!technology_) return no_technology_;
  const UnitParameters chip = technology_->chip_of(k).chip;
  if (const auto fault = faults_.find(chip.hash); fault != faults_.end()) return fault->second;
  return chips_.find(chip.hash) ? "" : chip.text() + " has not been mapped";
}

}  // namespace racebeam
