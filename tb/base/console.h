// Results on stdout, messages on stderr.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace racebeam {

/// From now on stdout is for print() alone: what anybody else writes there, such as RTL, a library
/// or a program that is started, goes to stderr.
void keep_stdout();

/// For a program that takes this one's place: stdout is as it was.
void give_back_stdout();

/// The file that print() writes to.
int stdout_file();

/// Writes results at once. Throws OutputError, as on a full disk; ClosedPipe if the reader is gone.
void print(std::string_view text);

/// One line for the user, on stderr, after "racebeam: ".
void tell(std::string_view text);

/// stderr is a terminal that can move its cursor.
bool on_terminal();
/// And wants colours: the environment has no NO_COLOR.
bool in_colours();
/// And somebody watches it: a line may be drawn over and over. Not where CI is set.
bool watched();

}  // namespace racebeam
