// The mutants of several units together.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tb/signoff/check_result.h"

namespace racebeam {

/// How many of these are at most 3, 10, 100, and so on up to 100,000, by these numbers.
nlohmann::ordered_json found_within(const std::vector<std::uint64_t>& clocks);

/// The sums of what the checks of mutants among `results` have counted; null of less than two.
nlohmann::ordered_json mutant_totals(const std::vector<CheckResult>& results);

/// "1790 of 2000 found, 205 proved equal; by random traffic 1700, 71.0 % within 100 clocks, 99.1 %
/// within 10000"; where each has been shrunk, how many become how small, too. "" of null.
std::string totals_text(const nlohmann::ordered_json& totals);

}  // namespace racebeam
