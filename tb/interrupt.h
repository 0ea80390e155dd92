// Ctrl-C and its relatives as a flag, so that a run can end between two frames.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// From now on SIGINT, SIGTERM and SIGHUP only set a flag; the third one ends the program at once
/// with 130. A caller that ignores SIGHUP (nohup) keeps it ignored.
void catch_interrupts();

/// One of them has arrived.
bool interrupted();

}  // namespace racebeam
