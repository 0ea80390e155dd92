// What a word of the command line may become: `racebeam --complete WORD...` tells it to a shell.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/program/command_text.h"

namespace racebeam {

/// The option before the words that completion scripts call the program with.
constexpr const char* CompleteOption = "--complete";

/// Words that the last of `words` may become, with their help: "WORD<tab>HELP", one a line. A line
/// ":files" or ":folders" if paths may stand there. `words` has no program's name; the last may be
/// empty.
std::string completions(const CommandText& program, const std::vector<std::string>& words);

}  // namespace racebeam
