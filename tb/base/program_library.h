// What only some commands need, and much else with it, is in libraries of the program's own: they
// are opened when they are first asked for, so that no other command pays for them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// Opens a library, which is beside the program as it is built, or where that is installed, and
/// finds what it has under a name. Throws MissingTool with `advice`.
const void* open_program_library(const char* file, const char* symbol, const char* advice);

}  // namespace racebeam
