// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/synthesis.h"

#include <fmt/format.h>

#include <sstream>

#include "tb/verilate/cache_folder.h"
#include "tb/verilate/run_tool.h"

namespace racebeam {

namespace {

constexpr std::size_t MostOfReason = 500;  // characters

/// The line of yosys that says why; else the end of all that was said, in one line.
std::string reason_in(const std::string& said) {
  std::istringstream lines(said);
  std::string all;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("ERROR: ") != std::string::npos) return line;
    if (line.find_first_not_of(" \t\r") != std::string::npos)
      all += (all.empty() ? "" : "; ") + line;
  }
  if (all.empty()) return "no word of why";
  return all.size() <= MostOfReason ? all : "... " + all.substr(all.size() - MostOfReason);
}

/// The figures of the last line, "stacks 86 217".
std::optional<UnitSilicon> figures_in(const std::string& said, const UnitParameters& unit) {
  const auto end = said.find_last_not_of('\n');
  if (end == std::string::npos) return {};
  const auto before = said.rfind('\n', end);
  const std::string line = said.substr(before == std::string::npos ? 0 : before + 1, end - before);
  std::istringstream words(line);
  std::string name, rest;
  UnitSilicon silicon{unit.hash, unit.unit, unit.parameters, GenericRecipe, 0, 0, {}};
  if (!(words >> name >> silicon.flip_flops >> silicon.cells) || words >> rest) return {};
  if (name != unit.unit || silicon.flip_flops < 0 || silicon.cells < silicon.flip_flops) return {};
  return silicon;
}

UnitOutcome outcome_of(const UnitParameters& unit, const ToolResult& result,
                       std::chrono::milliseconds limit) {
  const auto fault = [&unit](const std::string& why) {
    return UnitOutcome{{}, unit.text() + ": " + why};
  };
  if (result.late || !result.good) return fault(fault_of(result, limit, "yosys"));
  std::optional<UnitSilicon> silicon = figures_in(result.said, unit);
  if (!silicon) return fault(fault_of(result, limit, "yosys"));
  return {silicon, ""};
}

}  // namespace

std::string fault_of(const ToolResult& result, std::chrono::milliseconds limit, const char* tool) {
  if (result.late)
    return fmt::format("{} did not end within {:g} seconds", tool,
                       std::chrono::duration<double>(limit).count());
  return (result.good ? "no figures: " : "") + reason_in(result.said);
}

void synthesise(const std::vector<UnitParameters>& units, const SynthesisPlan& plan,
                const std::function<void(const UnitParameters&, const UnitOutcome&)>& done) {
  if (units.empty()) return;
  const WorkFolder work;
  std::vector<ToolRun> runs;
  for (const UnitParameters& unit : units) {
    ToolRun run{{recipe_file(), "--count", unit.unit}, "", {"TMPDIR=" + work.path()}, plan.tick};
    run.words.insert(run.words.end(), unit.settings.begin(), unit.settings.end());
    runs.push_back(run);
  }
  run_tools(runs, plan.jobs, plan.limit, [&](std::size_t number, const ToolResult& result) {
    done(units[number], outcome_of(units[number], result, plan.limit));
  });
}

}  // namespace racebeam
