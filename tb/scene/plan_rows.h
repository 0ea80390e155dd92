// PlanRows: the storeys of a plan as equal rows of characters, each with its place in the file.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tb/scene/toml_tree.h"

namespace racebeam {

/// A character of a plan: a Unicode code point as UTF-8.
using Letter = std::string;

/// The lines of a text, without their ends.
std::vector<std::string_view> split_lines(std::string_view text);
/// The code points of a text.
std::vector<Letter> letters(std::string_view text);

struct PlanRow {
  std::vector<Letter> cells;
  Place place;  ///< of the first cell
};

struct PlanRows {
  std::vector<std::vector<PlanRow>> storeys;  ///< storey, row: all of one size
  int rows = 0, columns = 0;                  ///< of each storey
};

/// Reads plan.storeys. False, and faults, if it is no rectangle. Rows are looked up in the lines of
/// the file for their places.
bool read_rows(const TomlNode& storeys, const std::vector<std::string_view>& file, PlanRows& to,
               Faults& faults);

}  // namespace racebeam
