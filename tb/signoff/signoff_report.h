// What a sign-off says: a table, JSON, JUnit's XML and a page.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/signoff/check_result.h"

namespace racebeam {

/// In the place of an engine's name.
constexpr const char* AllEngines = "all";

struct SignoffReport {
  std::string scene, engine;         ///< or AllEngines
  std::string command;               ///< that was given
  std::vector<CheckResult> results;  ///< in order of units
  bool whole = true;                 ///< false: interrupted

  /// Nothing is bad or undecided.
  bool green() const;
  /// "stacks"; of all engines "beam/stacks".
  std::string name(const CheckResult& result) const;
};

/// A line for each check of each unit, and below what is wrong.
std::string signoff_text(const SignoffReport& report);
std::string signoff_json(const SignoffReport& report);
/// A test suite for each check, a case for each unit. Bad is a failure, undecided an error.
std::string signoff_junit(const SignoffReport& report);
/// One HTML file without a script, that needs nothing else and reaches for nothing.
std::string signoff_page(const SignoffReport& report);

}  // namespace racebeam
