// Options that several commands have, and what they check.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include "tb/program/number_option.h"
#include "tb/show/run.h"
#include "tb/tt/tt_options.h"

namespace racebeam {

constexpr const char* FramesRange = "1..12799 in the demo";
constexpr const char* FirstRange = "0..12798 in the demo";

template <class Number>
CLI::Option* add_number(CLI::App& command, const char* name, Number& to, const char* help,
                        const CLI::Validator& number) {
  return command.add_option(name, to, help)->type_name("N")->check(number);
}

/// --set, of a command that runs the chip.
void add_set_option(CLI::App& command, RunOptions& options);

/// The options of a Tiny Tapeout chip, of a command that can run one.
void add_tt_options(CLI::App& command, TtOptions& options);

/// Refuses an empty name.
const CLI::Validator& not_empty();

}  // namespace racebeam
