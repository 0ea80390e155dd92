// From which sources the program was built, and how; cmake/build_origin.cmake writes it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// Of git, with "-changed" if files were other ones; "": built outside of git.
const char* source_commit();
/// "GNU 12.2.0 -O3 -DNDEBUG"
const char* compiler_text();

}  // namespace racebeam
