// Options that several commands have, and what they check.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/program/command_options.h"
#include "tb/program/number_option.h"
#include "tb/show/run.h"
#include "tb/tt/tt_options.h"
#include "tb/twin/channels.h"
#include "tb/twin/delays.h"

namespace racebeam {

constexpr const char* FramesRange = "1..12799 in the demo";
constexpr const char* FirstRange = "0..12798 in the demo";

template <class Number>
CommandOption add_number(const CommandOptions& command, const char* name, Number& to,
                         const char* help, const CheckWord& number) {
  return command.add_option(name, to, help).type_name("N").check(number);
}

/// --engine, with its help.
void add_engine_option(const CommandOptions& command, std::string& engine, const std::string& help);

/// --engine and --set, of a command that runs the chip.
void add_run_options(const CommandOptions& command, RunOptions& options);
/// --set alone, where scenes are of one engine.
void add_set_option(const CommandOptions& command, RunOptions& options);

/// --shake and --stall, of a command that runs the wired chip.
void add_shake_options(const CommandOptions& command, ShakeOptions& options);
/// --delays, of the same.
void add_delay_options(const CommandOptions& command, DelayOptions& options);
/// The options of a Tiny Tapeout chip, of a command that can run one.
void add_tt_options(const CommandOptions& command, TtOptions& options);

/// Frames or pictures: those of --at, or so many, spread over the show; 0: 3, or 1 of an engine
/// that does not race the beam. Throws UsageError.
std::vector<int> spread_numbers(const std::string& at, long long frames, const Show& show);

/// Refuses an empty name.
std::string not_empty(const std::string& word);

}  // namespace racebeam
