// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/signoff_asked.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "tb/base/errors.h"
#include "tb/base/nearest.h"
#include "tb/scene/engines.h"
#include "tb/signoff/signoff_report.h"
#include "tb/twin/twins.h"
#include "tb/twin/use_option.h"
#include "tb/verilate/rtl_plugin.h"

namespace racebeam {

namespace {

/// What the user asks for, in the order of the table.
std::vector<const SignoffCheck*> chosen_checks(const std::vector<std::string>& only) {
  std::vector<std::string> known;
  for (const SignoffCheck& check : signoff_checks()) known.emplace_back(check.name);
  for (const std::string& word : only)
    if (std::find(known.begin(), known.end(), word) == known.end())
      throw unknown_name("check", word, known);
  std::vector<const SignoffCheck*> chosen;
  for (const SignoffCheck& check : signoff_checks())
    if (only.empty() || std::find(only.begin(), only.end(), check.name) != only.end())
      chosen.push_back(&check);
  return chosen;
}

std::vector<const SignoffCheck*> of_chips(std::vector<const SignoffCheck*> checks) {
  checks.erase(std::remove_if(checks.begin(), checks.end(),
                              [](const SignoffCheck* check) { return !check->of_chips; }),
               checks.end());
  return checks;
}

/// Throws UsageError unless it is a unit of the run, or its whole chip.
void expect_unit(const std::string& unit, const Run& run) {
  const UseOption use(run.show.engine(), run.k, run.show.tables());
  if (unit == run.show.engine().top) use.check_whole_chip();
  else use.check_unit(unit);
}

/// Of "UNIT=FILE"; "UNIT=rtl" is the project's own RTL, as in other commands.
std::string file_of(const std::string& word) {
  const auto equals = word.find('=');
  if (equals == std::string::npos) return "";
  const std::string unit = word.substr(0, equals), file = word.substr(equals + 1);
  if (file.empty()) throw UsageError("'" + word + "' is not of the form UNIT or UNIT=FILE.sv");
  if (file == "rtl") return "";
  if (file == "gates")
    throw UsageError(word + ": gates are one of the checks: racebeam signoff " + unit +
                     " --only gates");
  const std::filesystem::path path(file);
  if (path.extension() == ".so")
    throw UsageError(word +
                     ": a plug-in has no text that mistakes could be put into; give its source, " +
                     unit + "=FILE.sv");
  if (path.extension().empty() && !std::filesystem::exists(path))
    throw UsageError("there is no file " + file);
  return file;
}

}  // namespace

std::vector<AskedUnit> asked_units(const std::vector<std::string>& words,
                                   const std::vector<std::string>& only, const Run& run) {
  const std::vector<const SignoffCheck*> checks = chosen_checks(only);
  const std::vector<const SignoffCheck*> chip_checks = of_chips(checks);
  const engine& built = run.show.engine();
  std::vector<AskedUnit> all;
  for (const std::string& word : words.empty() ? std::vector<std::string>{AllUnits} : words) {
    if (word == AllUnits) {
      for (const std::string& unit : built.unit_names(run.show.tables() != nullptr))
        all.push_back({unit, "", checks});
      if (!chip_checks.empty() && *built.top && twins_of(built).is_top(run.k, run.show.tables()))
        all.push_back({built.top, "", chip_checks});
      continue;
    }
    const std::string unit = word.substr(0, word.find('='));
    expect_unit(unit, run);
    const bool whole = unit == built.top;
    if (whole && chip_checks.empty())
      throw UsageError(fmt::format("--only {}: {} is the whole chip, whose units have that check",
                                   fmt::join(only, " --only "), unit));
    all.push_back({unit, file_of(word), whole ? chip_checks : checks});
  }
  return all;
}

std::vector<AskedPart> asked_parts(const RunOptions& options, const std::vector<std::string>& only,
                                   const std::string& folder) {
  const auto part_of = [&](const RunOptions& of, const std::string& in) {
    const Run run = open_run(of, true);
    return AskedPart{run, asked_units(of.units, only, run), in};
  };
  if (options.engine != AllEngines) return {part_of(options, folder)};
  if (options.scene != "demo" || !options.assignments.empty())
    throw UsageError("--engine all is for each engine as it is; leave out --scene and --set");
  for (const std::string& unit : options.units)
    if (unit != AllUnits)
      throw UsageError("--engine all is for all units; name the engine that has " + unit);
  std::vector<AskedPart> parts;
  for (const engine* one : engines()) {
    RunOptions own = options;
    own.engine = one->name;
    parts.push_back(part_of(own, folder + "/" + one->name));
  }
  return parts;
}

SignoffUnit unit_of(const AskedUnit& asked, const Run& run) {
  const engine& built = run.show.engine();
  const PluginMaker maker = twins_of(built).plugins(run.k, run.show.tables(), false);
  const bool open = asked.unit == built.top;  // lockstep looks at its wiring
  SignoffUnit unit{{asked.unit, "", run.k, run.show.tables(), run.show.frames()}, {}, asked.file};
  unit.sources = asked.file.empty() ? maker.own_rtl(asked.unit, open)
                                    : maker.users_rtl(asked.unit, asked.file, open);
  unit.dut.plugin = rtl_plugin(unit.sources);
  return unit;
}

}  // namespace racebeam
