// Results on stdout, messages on stderr.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace racebeam {

/// Writes results at once. Throws OutputError, also if the reader is gone or the disk is full.
void print(std::string_view text);

/// One line for the user, on stderr, after "racebeam: ".
void tell(std::string_view text);

/// stderr is a terminal that can move its cursor.
bool on_terminal();
/// And wants colours: the environment has no NO_COLOR.
bool in_colours();

}  // namespace racebeam
