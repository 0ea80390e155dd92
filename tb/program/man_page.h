// The manual page, from the commands and options as the help has them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/program/command_text.h"

namespace racebeam {

/// racebeam(1) for man, in its macros.
std::string man_page(const CommandText& program);

}  // namespace racebeam
