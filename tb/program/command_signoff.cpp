// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_signoff.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <thread>

#include "sc/swap/rtl_library.h"
#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/base/interrupt.h"
#include "tb/base/nearest.h"
#include "tb/base/output_file.h"
#include "tb/base/progress.h"
#include "tb/program/common_options.h"
#include "tb/scene/engines.h"
#include "tb/show/run.h"
#include "tb/signoff/signoff_report.h"
#include "tb/signoff/signoff_unit.h"
#include "tb/twin/twins.h"
#include "tb/twin/use_option.h"
#include "tb/verilate/rtl_plugin.h"
#include "tb/verilate/run_tool.h"

namespace racebeam {

namespace {

constexpr long long MostRandomClocks = 1'000'000'000'000;
constexpr long long LargestSeed = 0xffffffff;
constexpr int MostMutants = 100'000, MostJobs = 256, MostProofSeconds = 86'400;

struct Options : RunOptions {
  Options() { scene = "demo"; }
  SignoffOptions signoff{};
  std::vector<std::string> only{};
  std::string waivers{}, junit{}, page{}, command{};
  bool json = false;
};

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

struct Asked {
  std::string unit, file;  ///< file: empty for the unit's own RTL
};

std::vector<Asked> asked_units(const std::vector<std::string>& words, const Run& run) {
  std::vector<Asked> all;
  const std::vector<std::string> known = run.show.engine().unit_names(run.show.tables() != nullptr);
  for (const std::string& word : words.empty() ? std::vector<std::string>{AllUnits} : words) {
    const auto equals = word.find('=');
    const std::string unit = word.substr(0, equals);
    if (word == AllUnits) {
      for (const std::string& each : known) all.push_back({each, ""});
      continue;
    }
    if (std::find(known.begin(), known.end(), unit) == known.end()) {
      if (unit == run.show.engine().top)
        throw UsageError(unit +
                         " is the whole chip, which has no traffic of its own; sign off all");
      UseOption(run.show.engine(), run.k, run.show.tables()).check_unit(unit);
    }
    const std::string file = equals == std::string::npos ? "" : word.substr(equals + 1);
    if (equals != std::string::npos && file.empty())
      throw UsageError("'" + word + "' is not of the form UNIT or UNIT=FILE.sv");
    if (std::filesystem::path(file).extension() == ".so")
      throw UsageError(word +
                       ": a plug-in has no text that mistakes could be put into; give its "
                       "source, " +
                       unit + "=FILE.sv");
    if (!file.empty() && std::filesystem::path(file).extension().empty() &&
        !std::filesystem::exists(file))
      throw UsageError("there is no file " + file);
    all.push_back({unit, file});
  }
  return all;
}

SignoffUnit unit_of(const Asked& asked, const Run& run) {
  const PluginMaker maker = twins_of(run.show.engine()).plugins(run.k, run.show.tables(), false);
  SignoffUnit unit{{asked.unit, "", run.k, run.show.tables(), run.show.frames()}, {}, asked.file};
  unit.sources =
      asked.file.empty() ? maker.own_rtl(asked.unit) : maker.users_rtl(asked.unit, asked.file);
  unit.dut.plugin = rtl_plugin(unit.sources);
  return unit;
}

CheckResult undecided(const std::string& unit, const SignoffCheck& check, const std::string& why) {
  CheckResult result;
  result.unit = unit;
  result.check = check.name;
  result.verdict = CheckResult::Undecided;
  result.summary = "not run";
  result.faults = {why};
  return result;
}

std::string missing_tool(const SignoffCheck& check) {
  for (const char* tool : check.tools)
    if (!has_tool(tool)) return std::string(tool) + " is not installed; scripts/setup installs it";
  return "";
}

/// One check of a unit: whatever happens, the others go on.
CheckResult run_check(const SignoffCheck& check, const SignoffUnit& unit,
                      const SignoffOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  CheckResult result;
  try {
    result = check.run(unit, options);
  } catch (const MissingTool& error) {
    result = undecided(unit.dut.unit, check, error.what());
  } catch (const RtlError& error) {
    result = undecided(unit.dut.unit, check, error.what());
    result.verdict = CheckResult::Bad;
    result.summary = "the RTL cannot be checked";
  } catch (const ChildDied& error) {
    result = undecided(unit.dut.unit, check, error.what());
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_text(
      fmt::format("{}/{}.{}.json", options.folder, result.unit, check.name),
      to_json(result).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  return result;
}

SignoffReport sign_off(const Options& options, const Run& run,
                       const std::vector<const SignoffCheck*>& checks,
                       const std::vector<Asked>& asked) {
  SignoffReport report{options.scene, run.show.engine().name, options.command, {}, true};
  const auto all = static_cast<std::int64_t>(asked.size() * checks.size());
  Progress progress(all, "checks");
  SignoffOptions signoff = options.signoff;
  try {
    for (const Asked& one : asked) {
      std::optional<SignoffUnit> unit;
      for (const SignoffCheck* check : checks) {
        if (interrupted()) throw Interrupted();
        signoff.progress = [&](const std::string& note) {
          progress.draw(static_cast<std::int64_t>(report.results.size()), 0,
                        one.unit + " " + check->name + ": " + note);
        };
        signoff.progress("begins");
        if (const std::string missing = missing_tool(*check); !missing.empty()) {
          report.results.push_back(undecided(one.unit, *check, missing));
          continue;
        }
        try {
          if (!unit) unit = unit_of(one, run);
          report.results.push_back(run_check(*check, *unit, signoff));
        } catch (const RtlError& error) {  // it cannot be verilated
          report.results.push_back(undecided(one.unit, *check, error.what()));
          report.results.back().verdict = CheckResult::Bad;
        }
      }
    }
  } catch (const Interrupted&) {
    report.whole = false;
  }
  return report;
}

/// Red before incomplete.
int exit_code(const SignoffReport& report) {
  const auto any = [&](CheckResult::Verdict verdict) {
    return std::any_of(report.results.begin(), report.results.end(),
                       [&](const CheckResult& result) { return result.verdict == verdict; });
  };
  if (any(CheckResult::Bad)) return ExitDifference;
  return any(CheckResult::Undecided) ? ExitMissing : ExitGood;
}

int run_signoff(Options& options) {
  const std::vector<const SignoffCheck*> checks = chosen_checks(options.only);
  const Run run = open_run(options, true);
  const std::vector<Asked> asked = asked_units(options.units, run);
  options.signoff.waivers =
      read_waivers(options.waivers.empty() ? own_waivers_file() : options.waivers);
  for (const Waiver& waiver : options.signoff.waivers)
    if (std::none_of(engines().begin(), engines().end(),
                     [&](const engine* one) { return one->unit(waiver.unit) != nullptr; }))
      throw UsageError(waiver.place + ": no engine has a unit " + waiver.unit);
  for (const std::string& file : {options.junit, options.page})
    if (!file.empty()) const OutputFile tried(file);  // it is written after an hour
  make_folder(options.signoff.folder);
  catch_interrupts();
  const SignoffReport report = sign_off(options, run, checks, asked);
  write_text(options.page.empty() ? options.signoff.folder + "/signoff.html" : options.page,
             signoff_page(report));
  if (!options.junit.empty()) write_text(options.junit, signoff_junit(report));
  print(options.json ? signoff_json(report) : signoff_text(report));
  if (!report.whole) {
    tell("interrupted; what was found is kept; the same command goes on");
    return ExitInterrupted;
  }
  return exit_code(report);
}

void add_options(const CommandOptions& command, Options& options) {
  SignoffOptions& signoff = options.signoff;
  signoff.jobs = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, MostJobs);
  command
      .add_option("unit", options.units,
                  "UNIT; UNIT=FILE.sv, UNIT=A.sv+B.sv, UNIT=LIST.f, UNIT=FOLDER; or all")
      .type_name("UNIT");
  std::string checks;
  for (const SignoffCheck& check : signoff_checks())
    checks += fmt::format("{}{}: {}", checks.empty() ? "" : "; ", check.name, check.meaning);
  command.add_option("--only", options.only, "Run this check alone; repeatable. " + checks)
      .type_name("CHECK")
      .repeatable();
  command.add_option("--scene", options.scene, "demo, or a scene file")
      .type_name("SCENE")
      .capture_default_str();
  add_run_options(command, options);
  add_number(command, "--mutants", signoff.mutants, "Mutants of each unit, if there are so many",
             is_number_in("--mutants", 1, MostMutants))
      .capture_default_str();
  add_number(command, "--mutant-seed", signoff.mutant_seed, "Of the choice of mutants",
             is_number_in("--mutant-seed", 0, LargestSeed))
      .capture_default_str();
  add_number(command, "--random", signoff.random, "Clocks of random traffic",
             is_number_in("--random", 1, MostRandomClocks))
      .capture_default_str();
  add_number(command, "--seed", signoff.seed, "Of the random traffic",
             is_number_in("--seed", 0, LargestSeed))
      .capture_default_str();
  add_number(command, "--prove", signoff.proof_seconds,
             "Seconds for the proof of each mutant that is not found; 0: none",
             is_number_in("--prove", 0, MostProofSeconds))
      .capture_default_str();
  add_number(command, "--within", signoff.within,
             "Clocks; a mutant that random traffic finds later is not found, and gets a stream of "
             "its own. 0: none",
             is_number_in("--within", 0, MostRandomClocks))
      .capture_default_str();
  command.add_flag("--shrink", signoff.shrink,
                   "Shrink what random traffic finds of each mutant, and tell the sizes");
  add_number(command, "--jobs", signoff.jobs, "Processes at once; default: the cores",
             is_number_in("--jobs", 1, MostJobs));
  command
      .add_option("--waivers", options.waivers,
                  "Mutants that need not be found, instead of the project's list")
      .type_name("FILE.toml")
      .check(not_empty);
  command
      .add_option("-o,--output", signoff.folder,
                  "Folder: what is found is kept there, with the page signoff.html")
      .type_name("DIR")
      .check(not_empty)
      .capture_default_str();
  command.add_option("--html", options.page, "The page in another place")
      .type_name("FILE.html")
      .check(not_empty);
  command.add_option("--junit", options.junit, "The verdicts as JUnit's XML, for CI")
      .type_name("FILE.xml")
      .check(not_empty);
  command.add_flag("--json", options.json, "JSON on stdout instead of the table");
}

}  // namespace

Command signoff_row() {
  return {"signoff", "Try whether the checks of units would find mistakes", "Verify",
          "signoff stacks --junit signoff.xml", [](const CommandOptions& command) -> RunCommand {
            const auto options = std::make_shared<Options>();
            add_options(command, *options);
            return [options](const std::vector<std::string>& words) {
              for (const std::string& word : words)
                options->command += (options->command.empty() ? "" : " ") + word;
              return run_signoff(*options);
            };
          }};
}

}  // namespace racebeam
