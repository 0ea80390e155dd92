// What one check of a sign-off found of one unit.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace racebeam {

struct CheckResult {
  enum Verdict { Good, Bad, Undecided };  ///< Undecided: a tool is missing, or it was interrupted

  std::string unit,
      check;  ///< check: "mutants", "coverage", "reset", "comparator", "lint", "gates"
  Verdict verdict = Good;
  std::string summary;              ///< one line: "998 of 1,000 found, 2 proved equal"
  std::vector<std::string> faults;  ///< what is wrong and what to do, a line each; empty if Good
  nlohmann::ordered_json detail;    ///< figures, for the page
  double seconds = 0;
  std::string engine{};  ///< whose unit it is
};

nlohmann::ordered_json to_json(const CheckResult& result);
/// Throws nlohmann::json::exception.
CheckResult check_result_of(const nlohmann::ordered_json& json);

}  // namespace racebeam
