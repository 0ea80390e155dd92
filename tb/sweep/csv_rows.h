// CSV that a sweep has written, read back.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

namespace racebeam {

/// Its rows, the cells by the names in its head. What a short row lacks is "".
std::vector<std::map<std::string, std::string>> csv_rows(const std::string& text);

}  // namespace racebeam
