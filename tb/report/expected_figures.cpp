// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/expected_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tb/base/errors.h"
#include "tb/show/open_show.h"

namespace racebeam {

namespace {

constexpr const char *Exact = "exact", *Absent = "-";
constexpr const char* Form =
    "a line is GROUP ENGINE FIGURE VALUE TOLERANCE, as `common/balls block clocks_per_pixel 8.19 "
    "1%`";

/// Whether all of a word is one.
bool read_number(const std::string& word, double& to) {
  char* end = nullptr;
  to = std::strtod(word.c_str(), &end);
  return !word.empty() && *end == 0 && std::isfinite(to);
}

std::string word_of(std::string name) {
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

const ComparedCell* cell_of(const std::vector<ComparedGroup>& groups, const std::string& group,
                            const std::string& engine) {
  for (const ComparedGroup& one : groups)
    for (const ComparedEngine& column : one.engines)
      if (word_of(one.name) == group && column.engine == engine && column.cell)
        return &*column.cell;
  return nullptr;
}

}  // namespace

ExpectedFigures::ExpectedFigures(const std::string& path) : path_(path) {
  std::ifstream file(path);
  if (!file) throw UsageError("--expect: cannot read " + path);
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    std::istringstream text(line.substr(0, line.find('#')));
    std::vector<std::string> words;
    for (std::string word; text >> word;) words.push_back(word);
    if (!words.empty()) rows_.push_back(row_of(number, words));
  }
  if (rows_.empty()) throw UsageError(fmt::format("--expect: {} has no line; {}", path, Form));
}

ExpectedFigures::Row ExpectedFigures::row_of(int line,
                                             const std::vector<std::string>& words) const {
  const auto refuse = [&](const std::string& what) {
    return UsageError(fmt::format("{}:{}: {}", path_, line, what));
  };
  if (words.size() != 5) throw refuse(fmt::format("{} words; {}", words.size(), Form));
  Row row{line, words[0], words[1], words[2], words[3], 0, 0};
  try {
    engine_named(row.engine);
    compare_metric(row.figure);
  } catch (const UsageError& error) {
    throw refuse(error.what());
  }
  if (row.value != Exact && row.value != Absent && !read_number(row.value, row.number))
    throw refuse("'" + row.value + "' is no number; " + Form);
  std::string tolerance = words[4];
  const bool share = tolerance.back() == '%';
  if (share) tolerance.pop_back();
  if (!read_number(tolerance, row.tolerance) || row.tolerance < 0)
    throw refuse("the tolerance '" + words[4] + "' is no number; " + Form);
  if (share) row.tolerance *= std::abs(row.number) / 100;
  return row;
}

std::string ExpectedFigures::place(const Row& row) const {
  return fmt::format("{}:{}: {} of {} in {}", path_, row.line, row.figure, row.engine, row.group);
}

std::vector<std::string> ExpectedFigures::faults(const std::vector<ComparedGroup>& groups) const {
  std::vector<std::string> faults;
  for (const Row& row : rows_) {
    const ComparedCell* const cell = cell_of(groups, row.group, row.engine);
    if (!cell)
      throw UsageError(place(row) + " was not compared; leave out the line, or compare it");
    const auto at =
        std::find_if(compare_metrics().begin(), compare_metrics().end(),
                     [&](const CompareMetric& metric) { return metric.name == row.figure; });
    const std::optional<double> value =
        cell->metrics[static_cast<std::size_t>(at - compare_metrics().begin())];
    const std::string is = !value               ? Absent
                           : std::isinf(*value) ? Exact
                                                : fmt::format("{:.6g}", *value);
    const bool good = row.value == Exact || row.value == Absent
                          ? is == row.value
                          : value && std::abs(*value - row.number) <= row.tolerance;
    if (!good)
      faults.push_back(
          fmt::format("{} is {}, not {} within {:g}", place(row), is, row.value, row.tolerance));
  }
  return faults;
}

}  // namespace racebeam
