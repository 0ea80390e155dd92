// The lines of --help, in a window of 100 columns.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace racebeam {

/// `name` on the left, `text` in the column `left`, from the next line on if `name` is long.
std::string help_entry(const std::string& name, const std::string& text, std::size_t left);

}  // namespace racebeam
