// Scripts by which shells complete the program's command lines: they ask it with --complete.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

/// "bash" and so on.
std::vector<std::string> completion_shells();

/// The script for a shell. Throws UsageError for one that is not known.
std::string completion_script(const std::string& shell);

}  // namespace racebeam
