// Ctrl-C and its relatives: a flag, so that a run can end with what is whole, and an end for runs
// that do not look at it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// From now on SIGINT, SIGTERM and SIGHUP end the program at once with 130. A caller that ignores
/// SIGHUP (nohup) keeps it ignored.
void end_on_interrupts();

/// From now on they set a flag. RTL that is being evaluated after another second of processor time
/// is left with an RtlFault; a program that has not ended after a second of processor time, or five
/// seconds, or at the third signal, says so and ends with 130.
void catch_interrupts();

/// One of them has arrived.
bool interrupted();

/// What is whole is about to be written: from the signal on there are so many seconds for it.
void time_to_finish(int seconds = 10);

}  // namespace racebeam
