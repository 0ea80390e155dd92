// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_timing.h"

#include <fmt/format.h>

#include <algorithm>

#include "tb/base/console.h"
#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/sweep/figures.h"
#include "tb/sweep/interval_text.h"

namespace racebeam {

namespace {

std::string fault_note(const std::string& hash) { return "no silicon of " + hash; }

bool is_of(const std::string& figure, const std::string& technology) {
  if (figure_named(figure)->measure() != std::string("timing")) return false;
  return (figure.rfind("ice40.", 0) == 0) == (technology == Fpga);
}

std::string path_text(const MappedChip& chip) {
  return fmt::format("{} to {}", chip.from, chip.to);
}

}  // namespace

SweepTimings::SweepTimings(const SweepPlan& plan, Store& store, bool fresh)
    : plan_(plan), store_(store), fresh_(fresh) {
  if (plan.file.measure.timing == SweepTiming::Off) return;
  std::string said;
  for (const char* name : {StandardCells, Fpga}) try {
      if (!silicon_) silicon_.emplace(plan.scenes.front().show.engine());
      technologies_.emplace_back(*silicon_, name);
    } catch (const MissingTool& error) {
      if (needs(name)) throw;
      absent_ = true;
      if (said != error.what()) tell(fmt::format("no figures of {}: {}", name, error.what()));
      said = error.what();
    }
}

bool SweepTimings::needs(const std::string& technology) const {
  const auto& goals = plan_.file.goals;
  return std::any_of(goals.begin(), goals.end(),
                     [&](const Goal& goal) { return is_of(goal.figure, technology); });
}

void SweepTimings::give(int point, const MappedChip& chip, SweepState& state) {
  chips_[{point, chip.technology}] = chip;
  const auto set = [&](const char* figure, double value) { state.set_exact(point, figure, value); };
  if (chip.technology == Fpga) {
    set("ice40.flip_flops", static_cast<double>(chip.flip_flops));
    set("ice40.luts", static_cast<double>(chip.cells));
    set("ice40.clock", 1000 / chip.ns);
    return;
  }
  set("area", *chip.area);
  set("multipliers", 100 * *chip.multipliers / *chip.area);
  set("tiles", estimated_tiles(*chip.area));
  set("longest_path", chip.ns);
}

void SweepTimings::refuse(int point, const std::string& technology, const std::string& why,
                          Measurer& measurer) const {
  if (needs(technology)) measurer.refuse(point, "no silicon: " + why);
  else
    tell(fmt::format("no {} of {}: {}", technology,
                     plan_.points[static_cast<std::size_t>(point)].point.name, why));
}

void SweepTimings::measure(const std::vector<int>& points, SweepState& state, Measurer& measurer,
                           int jobs) {
  std::map<std::string, std::vector<int>> points_of;  // by hash
  std::vector<ChipWanted> missing;
  for (const Technology& technology : technologies_)
    for (const int point : points) try {
        const ChipWanted wanted =
            technology.chip_of(plan_.points[static_cast<std::size_t>(point)].k.front());
        const std::string& hash = wanted.chip.hash;
        if (const auto known = store_.chips.find(hash)) {
          give(point, *known, state);
          continue;
        }
        const std::string fault = fresh_ ? "" : store_.notes.find(fault_note(hash));
        if (!fault.empty()) {
          refuse(point, technology.name(), fault + "; --fresh tries again", measurer);
          continue;
        }
        if (points_of[hash].empty()) missing.push_back(wanted);
        points_of[hash].push_back(point);
      } catch (const NoSilicon& reason) {
        refuse(point, technology.name(), reason.what(), measurer);
      }
  if (missing.empty()) return;
  tell(counted(missing.size(), "whole chip") + " to be mapped: half a minute each");
  map_chips(missing, {jobs, ChipLimit, {}}, [&](const ChipWanted& wanted, const ChipOutcome& end) {
    if (end.mapped) store_.chips.put(*end.mapped);
    else store_.notes.put(fault_note(wanted.chip.hash), end.fault);
    for (const int point : points_of[wanted.chip.hash])
      if (end.mapped) give(point, *end.mapped, state);
      else refuse(point, wanted.technology, end.fault, measurer);
  });
}

std::string SweepTimings::text() const {
  std::string text;
  for (const auto& [key, chip] : chips_) {
    const std::string& name = plan_.points[static_cast<std::size_t>(key.first)].point.name;
    if (chip.area)
      text += fmt::format("{}: osu018 {} ns, {}; about {:.1f} tiles\n", name, text_of(chip.ns),
                          path_text(chip), estimated_tiles(*chip.area));
    else
      text += fmt::format("{}: ice40 {} MHz, {}\n", name, text_of(1000 / chip.ns), path_text(chip));
  }
  if (text.empty()) return text;
  return "longest paths, and tiles of Tiny Tapeout by an estimate (the taped-out chip, with sound, "
         "has 4 and 6,024 cells):\n" +
         text;
}

}  // namespace racebeam
