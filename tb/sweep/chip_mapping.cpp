// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/chip_mapping.h"

#include <fmt/format.h>

#include <charconv>
#include <sstream>

#include "tb/base/errors.h"
#include "tb/base/whole_file.h"
#include "tb/sweep/sweep_kinds.h"
#include "tb/verilate/cache_folder.h"

namespace racebeam {

namespace {

constexpr auto VersionLimit = std::chrono::seconds(60);

std::string script() { return recipe_file("timing"); }

std::string versions_of(const std::string& technology) {
  ToolResult answer{};
  run_tools({{{script(), technology, "--version"}, "", {}, {}}}, 1, VersionLimit,
            [&answer](std::size_t, const ToolResult& result) { answer = result; });
  if (answer.late) throw MissingTool("the tools of " + technology + " do not say their versions");
  if (!answer.good)
    throw MissingTool(answer.said.substr(0, answer.said.find_last_not_of('\n') + 1));
  return answer.said;
}

/// "-" or a number.
std::optional<double> number_in(const std::string& word) {
  double number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) return {};
  return number;
}

/// The figures of the last line, "racebeam_top 463 8521 266326 38660 22.727 u_a.b_q u_c.d_q[1]".
std::optional<MappedChip> figures_in(const std::string& said, const ChipWanted& wanted) {
  const auto end = said.find_last_not_of('\n');
  if (end == std::string::npos) return {};
  const auto before = said.rfind('\n', end);
  const std::string line = said.substr(before == std::string::npos ? 0 : before + 1, end - before);
  std::istringstream words(line);
  std::string name, area, multipliers, rest;
  MappedChip chip;
  chip.hash = wanted.chip.hash;
  chip.top = wanted.chip.unit;
  chip.parameters = wanted.chip.parameters;
  chip.technology = wanted.technology;
  if (!(words >> name >> chip.flip_flops >> chip.cells >> area >> multipliers >> chip.ns >>
        chip.from >> chip.to) ||
      words >> rest)
    return {};
  chip.area = number_in(area);
  chip.multipliers = number_in(multipliers);
  const bool has_area = wanted.technology == StandardCells;
  if (name != chip.top || chip.flip_flops < 0 || chip.cells <= 0 || chip.ns <= 0 ||
      chip.area.has_value() != has_area || chip.multipliers.has_value() != has_area)
    return {};
  return chip;
}

ChipOutcome outcome_of(const ChipWanted& wanted, const ToolResult& result,
                       std::chrono::milliseconds limit) {
  ChipOutcome outcome;
  if (result.good && !result.late) outcome.mapped = figures_in(result.said, wanted);
  if (!outcome.mapped)
    outcome.fault = fmt::format("{} in {}: {}", wanted.chip.text(), wanted.technology,
                                fault_of(result, limit, "scripts/timing"));
  return outcome;
}

}  // namespace

Technology::Technology(const Silicon& silicon, const std::string& name)
    : silicon_(silicon),
      name_(name),
      recipe_(content_key({name, whole_file(script()), versions_of(name)})) {}

ChipWanted Technology::chip_of(const knob_values& k) const {
  ChipWanted wanted{silicon_.chip_of(k), name_, {script(), name_, silicon_.of().top}};
  std::vector<std::string> options;
  if (silicon_.of().unit(Sound)) options = {"--without", Sound};
  if (name_ == StandardCells)
    for (const multiplier_row& row : sweep_kind(silicon_.of()).made_of(k, nullptr).multipliers)
      options.insert(options.end(), {"--multiplier", fmt::format("{}x{}x{}-{}", row.count,
                                                                 row.a_bits, row.b_bits, row.cut)});
  std::vector<std::string> key = {recipe_, wanted.chip.hash};
  key.insert(key.end(), options.begin(), options.end());
  wanted.chip.hash = content_key(key);
  for (const auto* list : {&options, &wanted.chip.settings})
    wanted.words.insert(wanted.words.end(), list->begin(), list->end());
  return wanted;
}

void map_chips(const std::vector<ChipWanted>& chips, const SynthesisPlan& plan,
               const std::function<void(const ChipWanted&, const ChipOutcome&)>& done) {
  if (chips.empty()) return;
  const WorkFolder work;
  std::vector<ToolRun> runs;
  for (const ChipWanted& chip : chips)
    runs.push_back({chip.words, "", {"TMPDIR=" + work.path()}, plan.tick});
  run_tools(runs, plan.jobs, plan.limit, [&](std::size_t number, const ToolResult& result) {
    done(chips[number], outcome_of(chips[number], result, plan.limit));
  });
}

double estimated_tiles(double area) {
  constexpr double Nand = 24, SkyNand = 3.7536, Tile = 161 * 111.52, Filled = 0.6;
  return area / Nand * SkyNand / (Tile * Filled);
}

}  // namespace racebeam
