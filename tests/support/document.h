// Pages of the project as a test reads them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

/// A page, by its path in the project. Throws std::runtime_error if it cannot be read.
std::string page(const std::string& path);

/// The cells of the rows of Markdown's tables between the heading that begins with `heading` and
/// the next one, without head rows; of its n-th table only if `n` is not -1. Throws
/// std::runtime_error if there is none.
std::vector<std::vector<std::string>> table_rows(const std::string& text,
                                                 const std::string& heading, int n = -1);

/// All whole numbers in a text, "-319, 0, 95" or "+512 -1".
std::vector<int> numbers(const std::string& text);

}  // namespace racebeam
