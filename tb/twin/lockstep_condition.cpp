// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/lockstep_condition.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

#include "tb/base/counted.h"
#include "tb/base/reset_value.h"

namespace racebeam {

namespace {

using Difference = LockstepDifference;

/// Whether some output differs, row by row; not in those that were not compared.
std::vector<bool> differing_rows(const Difference& d) {
  std::vector<bool> rows;
  for (std::size_t row = 0; row < d.history.size(); ++row) {
    bool differs = false;
    for (std::size_t n = 1; n < d.columns.size(); ++n)
      differs |= d.columns[n].side == Difference::Rtl && d.history[row][n] != d.history[row][n - 1];
    rows.push_back(differs && row >= d.before);
  }
  return rows;
}

/// The value of a column in all rows that differ.
std::optional<std::uint64_t> common_value(const Difference& d, const std::vector<bool>& differs,
                                          std::size_t column) {
  const std::uint64_t value = d.history[d.before][column];
  for (std::size_t row = 0; row < differs.size(); ++row)
    if (differs[row] && d.history[row][column] != value) return std::nullopt;
  return value;
}

}  // namespace

// Clocks side by side depend on each other: a row of differing clocks counts as one.
std::string difference_condition(const Difference& d) {
  constexpr double Chance = 1e-4;
  constexpr int WidestPort = 8;
  const std::vector<bool> differs = differing_rows(d);
  int times = 0, clocks = 0;
  for (std::size_t row = 0; row < differs.size(); ++row) {
    clocks += differs[row];
    times += differs[row] && (row == 0 || !differs[row - 1]);
  }
  double least = Chance;
  std::string text;
  for (std::size_t n = 0; n < d.columns.size(); ++n) {
    const auto& column = d.columns[n];
    if (column.side == Difference::Rtl || column.bits > WidestPort || column.port == d.port ||
        reset_value(column.port) >= 0)
      continue;
    const auto value = common_value(d, differs, n);
    if (!value) continue;
    double having = 0;
    for (const auto& row : d.history) having += row[n] == *value;
    const double chance = std::pow(having / static_cast<double>(d.history.size()), times);
    if (chance >= least) continue;
    least = chance;
    text = fmt::format("only while {} is {:x}: so it is in all {} that differ, and in {:.0f} of {}",
                       column.port, *value, counted(clocks, "clock"), having,
                       counted(d.history.size(), "clock"));
  }
  return text;
}

}  // namespace racebeam
