// The manual page, from the commands and options as the help has them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace racebeam {

/// racebeam(1) for man, in its macros.
std::string man_page(const CLI::App& app);

}  // namespace racebeam
