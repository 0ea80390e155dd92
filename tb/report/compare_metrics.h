// The figures of `racebeam compare`: each has one definition, a formula over numbers that have
// names.
//
// The numbers are what was counted, drawn and judged (compare_numbers()), what silicon.h has, and
// the quantities of the engine (compare_quantities()), which its own formulas make of its counters.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace racebeam {

/// By name.
using Numbers = std::map<std::string, double>;

struct CompareName {
  const char *name, *meaning;
};

struct CompareMetric {
  const char *name, *title, *unit, *meaning, *formula;
  int decimals;           ///< for people
  bool measured = false;  ///< by the clock of this machine: not the same twice
};

const std::vector<CompareMetric>& compare_metrics();
/// Throws UsageError, which names the nearest one.
const CompareMetric& compare_metric(const std::string& name);
/// Of the table in docs/compare.md.
std::string metric_row(const CompareMetric& metric);
/// Those of each cell besides counters and the engine's own.
const std::vector<CompareName>& compare_numbers();
/// Those that each engine has a formula for.
const std::vector<CompareName>& compare_quantities();

/// What a formula makes of the numbers; nullopt if it is empty or one is not there.
std::optional<double> formula_value(const std::string& formula, const Numbers& numbers);

}  // namespace racebeam
