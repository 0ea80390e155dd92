// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/common_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "tb/base/errors.h"
#include "tb/render/frame_plan.h"
#include "tb/scene/engines.h"

namespace racebeam {

std::string not_empty(const std::string& word) { return word.empty() ? "an empty name" : ""; }

void add_engine_option(const CommandOptions& command, std::string& engine,
                       const std::string& help) {
  std::string names;
  for (const racebeam::engine* one : engines())
    names += fmt::format("; {}: {}", one->name, one->meaning);
  command.add_option("--engine", engine, help + names).type_name("ENGINE").check(not_empty);
}

void add_run_options(const CommandOptions& command, RunOptions& options) {
  add_engine_option(command, options.engine, "The scene must be for this engine");
  add_set_option(command, options);
}

void add_set_option(const CommandOptions& command, RunOptions& options) {
  command.add_option("--set", options.assignments, "Set a knob (`racebeam knobs`); repeatable")
      .type_name("KNOB=VALUE")
      .repeatable();
}

void add_shake_options(const CommandOptions& command, ShakeOptions& options) {
  command
      .add_option(
          "--shake", options.shake,
          "Stall the handshakes between units at random, in bursts that begin and go on "
          "with these probabilities in each clock (0.05, 0.75); `racebeam shake --channels`")
      .type_name("SEED[,BEGIN,GO_ON]")
      .check(not_empty);
  command.add_option("--stall", options.stalls, "With --shake: this channel only; repeatable")
      .type_name("CHANNEL")
      .repeatable();
}

void add_delay_options(const CommandOptions& command, DelayOptions& options) {
  command
      .add_option("--delays", options.delays,
                  "Put registers into the channels between units, as this file says; `racebeam "
                  "delays new` writes it")
      .type_name("F.toml")
      .check(not_empty);
}

void add_tt_options(const CommandOptions& command, TtOptions& options) {
  command
      .add_option("--tt", options.project,
                  "Instead of a scene: verilate the chip of this Tiny Tapeout project (info.yaml) "
                  "and run it")
      .type_name("DIR")
      .check(not_empty);
  add_number(command, "--ui", options.ui, "Input pins ui_in of the chip of --tt, 0..255",
             is_number("--ui", "0..255"));
  add_number(command, "--uio", options.uio, "Input pins uio_in of the chip of --tt, 0..255",
             is_number("--uio", "0..255"));
  command
      .add_option("--clock-hz", options.reading.clock_hz,
                  "The clock of the chip of --tt, instead of clock_hz of info.yaml")
      .type_name("N")
      .check(is_number("--clock-hz", "in Hz"));
  command.add_option("--define", options.reading.defines, "Define a macro for --tt; repeatable")
      .type_name("NAME[=VALUE]")
      .repeatable();
  command
      .add_option("-I,--include", options.reading.include_folders,
                  "Look for includes of --tt here, before its own folders; repeatable")
      .type_name("DIR")
      .repeatable();
  command.add_flag("--trust", options.reading.trust,
                   "Let the RTL of --tt run commands and read and write any file");
  command
      .add_option("--inputs", options.inputs,
                  "Input pins of the chip of --tt that change in time, as `view --record-inputs` "
                  "writes them: frame,line,clock,ui,uio")
      .type_name("FILE.csv")
      .check(not_empty);
}

std::vector<int> spread_numbers(const std::string& at, long long frames, const Show& show) {
  std::vector<int> numbers;
  if (!at.empty()) {
    const FramePlan plan(at, show.frames());
    for (int n = 0; n < plan.count(); ++n) numbers.push_back(plan.number(n));
    return numbers;
  }
  const int usual = show.engine().races_beam ? 3 : 1;
  const long long count = frames ? frames : std::min(usual, show.frames());
  if (count < 1 || count > show.frames())
    throw UsageError(
        fmt::format("--frames {} is out of range; the scene has {}", count, show.frames()));
  for (long long n = 0; n < count; ++n)
    numbers.push_back(static_cast<int>(n * show.frames() / count));
  return numbers;
}

}  // namespace racebeam
