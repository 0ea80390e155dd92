// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_signoff.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

#include "sc/swap/rtl_library.h"
#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/base/progress.h"
#include "tb/program/common_options.h"
#include "tb/program/signoff_asked.h"
#include "tb/scene/engines.h"
#include "tb/show/run.h"
#include "tb/show/set_knob.h"
#include "tb/signoff/signoff_report.h"
#include "tb/signoff/signoff_unit.h"
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
  result.engine = engine_of(unit.dut.k).name;
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  write_text(
      fmt::format("{}/{}.{}.json", options.folder, result.unit, check.name),
      to_json(result).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  return result;
}

/// Those of a file that was named hold for any RTL; the project's own for its RTL, in the standard
/// chip: in another one other mutants are undecided.
std::vector<Waiver> waivers_of(const AskedUnit& one, const Options& options, const Run& run) {
  const bool own_rtl = one.file.empty() && knobs_text(run.k) == "default";
  return own_rtl || !options.waivers.empty() ? options.signoff.waivers : std::vector<Waiver>{};
}

/// Adds to the report.
void sign_off(const Options& options, const AskedPart& part, SignoffReport& report) {
  const Run& run = part.run;
  std::int64_t all = 0, done = 0;
  for (const AskedUnit& one : part.units) all += static_cast<std::int64_t>(one.checks.size());
  Progress progress(all, "checks");
  SignoffOptions signoff = options.signoff;
  signoff.folder = part.folder;
  make_folder(signoff.folder);
  const auto add = [&](CheckResult result) {
    result.engine = run.show.engine().name;
    report.results.push_back(std::move(result));
    ++done;
  };
  try {
    for (const AskedUnit& one : part.units) {
      std::optional<SignoffUnit> unit;
      signoff.waivers = waivers_of(one, options, run);
      for (const SignoffCheck* check : one.checks) {
        if (interrupted()) throw Interrupted();
        signoff.progress = [&](const std::string& note) {
          progress.draw(done, 0, one.unit + " " + check->name + ": " + note);
        };
        signoff.progress("begins");
        if (const std::string missing = missing_tool(*check); !missing.empty()) {
          add(undecided(one.unit, *check, missing));
          continue;
        }
        try {
          if (!unit) unit = unit_of(one, run);
          add(run_check(*check, *unit, signoff));
        } catch (const RtlError& error) {  // it cannot be verilated
          CheckResult bad = undecided(one.unit, *check, error.what());
          bad.verdict = CheckResult::Bad;
          add(std::move(bad));
        }
      }
    }
  } catch (const Interrupted&) {
    report.whole = false;
  }
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
  const std::vector<AskedPart> parts = asked_parts(options, options.only, options.signoff.folder);
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
  const bool one = parts.size() == 1;
  SignoffReport report{
      options.scene, one ? parts[0].run.show.engine().name : AllEngines, options.command, {}, true};
  for (const AskedPart& part : parts)
    if (report.whole) sign_off(options, part, report);
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
  add_engine_option(command, options.engine,
                    "The scene must be for this engine; all: each of them, with all its units");
  add_set_option(command, options);
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
  add_number(
      command, "--prove", signoff.proof_seconds,
      "Seconds of a processor's work for the proof of each mutant that is not found; 0: none",
      is_number_in("--prove", 0, MostProofSeconds))
      .capture_default_str();
  command.add_flag("--prove-again", signoff.prove_again, "Prove equal what was proved before, too");
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
