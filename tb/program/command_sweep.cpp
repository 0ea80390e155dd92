// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_sweep.h"

#include <chrono>
#include <filesystem>
#include <thread>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/program/common_options.h"
#include "tb/sweep/block_worker.h"
#include "tb/sweep/figures.h"
#include "tb/sweep/starter_sweep.h"
#include "tb/sweep/sweep_against.h"
#include "tb/sweep/sweep_run.h"
#include "tb/sweep/sweep_status.h"

namespace racebeam {

namespace {

struct Options {
  SweepOptions run;
  bool watch = false, json = false;
  int sample = 20;
  int rung = 0, block = 0;
  bool no_wait = false, expect_same = false;
  std::string csv, frames_csv, json_file, against;
};

int cores() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

int sweep_new(const Options& options) {
  const std::string& file = options.run.file;
  std::error_code ignored;
  if (std::filesystem::exists(std::filesystem::symlink_status(file, ignored)))
    throw UsageError(file + " exists; choose another name");
  write_text(file, starter_sweep());
  tell("wrote " + file + "; try `racebeam sweep run " + file + " -o out --dry-run`");
  return ExitGood;
}

int sweep_figures(const Options&) {
  print(figures_text());
  return ExitGood;
}

int sweep_run(const Options& options) {
  SweepOptions run = options.run;
  run.wait = !options.no_wait;
  if (run.on != "slurm" && (!run.slurm.empty() || options.no_wait))
    throw UsageError("--slurm and --no-wait are for --on slurm");
  if (run.on == "local" && run.tasks > 0)
    throw UsageError("--tasks is for --on slurm or --on hand; here there are --jobs");
  return run_sweep(run);
}

int sweep_work(const Options& options) {
  return work_on_block(options.run.folder, options.rung, options.block);
}

std::string is_place(const std::string& word) {
  return word == "local" || word == "slurm" || word == "hand"
             ? ""
             : "is local, slurm or hand, not " + word;
}

int sweep_status(const Options& options) {
  constexpr std::chrono::seconds Pause(1);
  if (options.watch) catch_interrupts();
  for (;;) {
    const bool goes_on = options.watch && is_running(options.run.folder);
    print(status_text(options.run.folder, options.json));
    if (!goes_on) return ExitGood;
    if (interrupted()) return ExitInterrupted;
    std::this_thread::sleep_for(Pause);
  }
}

int sweep_check(const Options& options) {
  std::string report;
  const bool good = check_sweep(options.run.folder, options.sample, options.run.jobs, report);
  print(report);
  return good ? ExitGood : ExitDifference;
}

int sweep_export(const Options& options) {
  const std::string& folder = options.run.folder;
  if (options.csv.empty() && options.frames_csv.empty() && options.json_file.empty())
    throw UsageError("sweep export needs --csv, --frames or --json, with a file");
  if (!options.csv.empty()) export_sweep(folder, ExportKind::Points, options.csv);
  if (!options.frames_csv.empty()) export_sweep(folder, ExportKind::Frames, options.frames_csv);
  if (!options.json_file.empty()) export_sweep(folder, ExportKind::Json, options.json_file);
  return ExitGood;
}

int sweep_compare(const Options& options) {
  const SweepAgainst against = sweep_against(options.run.folder, options.against);
  print(options.json ? against_json(against) : against_text(against));
  return options.expect_same && !against.same() ? ExitDifference : ExitGood;
}

void add_file(const CommandOptions& command, Options& options, const char* type) {
  command.add_option("file", options.run.file, "Sweep file (TOML)").required().type_name(type);
}

void add_folder(const CommandOptions& command, Options& options) {
  command.add_option("folder", options.run.folder, "What -o of sweep run has named")
      .required()
      .type_name("DIR")
      .check(not_empty);
}

void add_jobs(const CommandOptions& command, Options& options) {
  options.run.jobs = cores();
  add_number(command, "--jobs", options.run.jobs, "Workers at once; default: the cores",
             is_number_in("--jobs", 1, 256));
}

void add_run_options(const CommandOptions& run, Options& options) {
  add_file(run, options, "SWEEP");
  run.add_option("-o,--output", options.run.folder, "Folder: results are kept there, and found")
      .required()
      .type_name("DIR")
      .check(not_empty);
  add_jobs(run, options);
  run.add_option("--set", options.run.assignments, "Take no other value of this knob (repeatable)")
      .type_name("KNOB=VALUE")
      .repeatable();
  run.add_option("--reuse", options.run.reuse,
                 "Take equal results from the folder of another sweep (repeatable)")
      .type_name("DIR")
      .repeatable();
  run.add_flag("--fresh", options.run.fresh,
               "Try again what failed; with another model measure anew, the "
               "old results are kept");
  run.add_flag("--dry-run", options.run.dry_run,
               "Say points, frames, time and disk; write nothing");
}

void add_cluster_options(const CommandOptions& run, Options& options) {
  run.add_option("--on", options.run.on,
                 "Where: local; slurm, as an array of tasks; hand, by workers that you start")
      .type_name("PLACE")
      .capture_default_str()
      .check(is_place);
  run.add_option("--slurm", options.run.slurm, "For sbatch, such as \"--partition=night\"")
      .type_name("OPTIONS")
      .check(not_empty);
  add_number(run, "--tasks", options.run.tasks,
             "Tasks of a rung there; default: as many as take 60 to 120 s each",
             is_number_in("--tasks", 1, 1'000'000));
  run.add_flag("--no-wait", options.no_wait, "Queue, and end; the same command collects");
}

void add_work_options(const CommandOptions& work, Options& options) {
  add_folder(work, options);
  constexpr int Most = 1'000'000;
  add_number(work, "--rung", options.rung, "Of the plan: plan/N.json",
             is_number_in("--rung", 1, Most))
      .required();
  add_number(work, "--block", options.block, "Of its blocks, from 0 on",
             is_number_in("--block", 0, Most))
      .required();
}

void add_compare_options(const CommandOptions& command, Options& options) {
  add_folder(command, options);
  command
      .add_option("--against", options.against,
                  "Folder of a sweep before; DIR itself: its model before")
      .required()
      .type_name("DIR")
      .check(not_empty);
  command.add_flag("--expect-same", options.expect_same, "Exit code 1 if a point has changed");
  command.add_flag("--json", options.json, "JSON on stdout instead of the text");
}

void add_export_options(const CommandOptions& command, Options& options) {
  add_folder(command, options);
  const auto file = [&](const char* name, std::string& to, const char* help) {
    command.add_option(name, to, help).type_name("FILE").check(not_empty);
  };
  file("--csv", options.csv, "One row a point: settings, means");
  file("--frames", options.frames_csv, "One row a frame, with all that was counted");
  file("--json", options.json_file, "Everything");
}

}  // namespace

Command sweep_row() {
  return {"sweep", "Measure many settings, compare, keep, go on", "Change", "sweep new my.toml",
          [](const CommandOptions& command) -> RunCommand {
            const auto options = std::make_shared<Options>();
            const auto chosen = std::make_shared<int (*)(const Options&)>();
            const auto add = [&](const char* name, const char* help, int (*run)(const Options&)) {
              return command.add_subcommand(name, help, [chosen, run] { *chosen = run; });
            };
            add_file(add("new", "Write a sweep to start from", sweep_new), *options, "FILE");
            add("figures", "List what is measured of a point, for goals", sweep_figures);
            const CommandOptions run = add("run", "Start, or go on: the same command", sweep_run);
            add_run_options(run, *options);
            add_cluster_options(run, *options);
            add_work_options(
                add("work", "Measure a block that sweep run --on has planned", sweep_work),
                *options);
            const CommandOptions status =
                add("status", "How far it is, who works on it, what failed", sweep_status);
            add_folder(status, *options);
            status.add_flag("--watch", options->watch, "Again every second, until it ends");
            status.add_flag("--json", options->json, "JSON on stdout instead of the text");
            const CommandOptions check =
                add("check", "Whether the store is sound, and stored frames repeat", sweep_check);
            add_folder(check, *options);
            add_number(check, "--sample", options->sample, "Stored frames to measure again",
                       is_number_in("--sample", 0, 1'000'000))
                .capture_default_str();
            add_jobs(check, *options);
            add_compare_options(
                add("compare", "What changed since another sweep, or another model", sweep_compare),
                *options);
            add_export_options(add("export", "Results as CSV or JSON", sweep_export), *options);
            return [options, chosen](const std::vector<std::string>& words) {
              options->run.command.clear();
              for (const std::string& word : words)
                options->run.command += (options->run.command.empty() ? "" : " ") + word;
              return (*chosen)(*options);
            };
          }};
}

}  // namespace racebeam
