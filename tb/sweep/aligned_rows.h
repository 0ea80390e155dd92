// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace racebeam {

/// The cells of a row.
using TextRow = std::vector<std::string>;

/// A line for each row, the cells of a column below each other.
std::string aligned(const std::vector<TextRow>& rows);

}  // namespace racebeam
