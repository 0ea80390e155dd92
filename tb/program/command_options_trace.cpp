// The options of `racebeam trace`, which has the most.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "tb/program/command_options.h"
#include "tb/program/number_option.h"

namespace racebeam {

void add_trace(CLI::App& app, TraceOptions& options) {
  CLI::App* trace = app.add_subcommand(
      "trace",
      "Write the chip's signals or transactions as a waveform or a picture, or compare two");
  trace
      ->add_option("scene", options.scene,
                   "demo, or a scene file; or a waveform FILE.vcd for --picture to draw")
      ->type_name("SCENE");
  const auto text = [&](const char* name, std::string& to, const char* type, const char* help) {
    trace->add_option(name, to, help)->type_name(type)->check(not_empty());
  };
  const auto list = [&](const char* name, std::vector<std::string>& to, const char* type,
                        const char* help) {
    trace->add_option(name, to, help)->type_name(type)->allow_extra_args(false);
  };
  text("-o,--output", options.output, "FILE",
       "FILE.vcd, or FILE.fst by vcd2fst; FILE.gtkw for GTKWave is written beside it, "
       "and never replaces one that GTKWave saved");
  trace
      ->add_option("--level", options.level,
                   "signal: units wired at 50.4 MHz; tlm: lines, intervals, rooms, restarts and "
                   "display writes as transactions, small and fast enough for many frames")
      ->type_name("LEVEL")
      ->check(not_empty())
      ->capture_default_str();
  text("--picture", options.picture, "FILE.svg",
       "Draw the window, for documents; of at most 400 clocks and 100 signals");
  text("--from", options.from, "FRAME:LINE[:CLOCK]", "First clock; lines are -273..251");
  text("--to", options.to, "FRAME:LINE[:CLOCK]", "Last clock; without CLOCK the line's last");
  text(
      "--around", options.around, "TRIGGER",
      "first-starved, first-restart, max-stack, or mismatch (of units in lockstep) instead: looked "
      "for from --from, 0, up to --to, the end of that frame");
  text("--when", options.when, "CONDITION",
       "The first clock in which it is true instead: 'u_subdivider.sd_q == 4 && line == 240'; "
       "looked for as --around is");
  const auto number = [&](const char* name, auto& to, const char* help) {
    return trace->add_option(name, to, help)->type_name("N")->check(is_number(name, "0 or more"));
  };
  number("--lines", options.lines, "Lines before and after the one of --around or --when")
      ->default_str("1");
  number("--pre", options.pre, "Clocks before it instead of lines");
  number("--post", options.post, "Clocks after it instead of lines");
  number("--record", options.record,
         "Flight recorder: run from --from to --to, and write the last N lines only if something "
         "happens: --when, a mismatch in lockstep, a crash, Ctrl-C");
  list("--scope", options.scopes, "GLOB",
       "Only signals that match, or that such a scope holds: 'chip.u_subdivider', '*.i1_q'; "
       "repeatable; with --diff, only these are compared");
  number("--depth", options.depth, "Levels of the hierarchy, 1: the chip's own; 0: all")
      ->capture_default_str();
  add_tt_options(*trace, options);
  list("--set", options.assignments, "KNOB=VALUE", "Set a knob (`racebeam knobs`); repeatable");
  list("--use", options.units, "UNIT=IMPLEMENTATION",
       "Put RTL in a unit's place, as in render; its own signals are shown too; repeatable");
  trace->add_option("--diff", options.diff, "Instead of a scene: compare two files")
      ->type_name("A.vcd B.vcd")
      ->expected(2);
  trace->add_flag("--shared", options.shared,
                  "With --diff: only the signals and the time that both files have");
}

}  // namespace racebeam
