// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/columns.h"

#include <algorithm>
#include <string_view>

#include "sc/base/constants.h"
#include "sc/beam/frame_stats.h"
#include "tb/base/spread.h"
#include "tb/sweep/database.h"
#include "tb/sweep/row_digest.h"
#include "tb/sweep/sweep_kinds.h"

namespace racebeam {

namespace {

/// A percentile of a histogram, if an engine has that.
struct Percentile {
  const char* histogram;
  int percent;
  int width;         ///< of a bin
  std::int64_t all;  ///< what the histogram lacks of these counts as 0; 0: of its own ones

  std::string column() const { return std::string(histogram) + ".p" + std::to_string(percent); }
};
constexpr std::int64_t Pixels = std::int64_t(VisibleColumns) * VisibleRows;
constexpr Percentile percentiles[] = {
    {"fifo_fill", 50, 1, 0}, {"slack", 1, SlackBin, Pixels}, {"slack", 50, SlackBin, Pixels}};

std::int64_t sum_of(const std::vector<std::uint64_t>& bins) {
  std::uint64_t sum = 0;
  for (std::size_t n = 0; n < bins.size(); ++n) sum += n * bins[n];
  return static_cast<std::int64_t>(sum);
}

/// The least value that is not exceeded by `percent` of all; values lie evenly in a bin.
std::int64_t value_of(const Percentile& of, const std::vector<std::uint64_t>& bins) {
  std::int64_t there = 0;
  for (const std::uint64_t bin : bins) there += static_cast<std::int64_t>(bin);
  const std::int64_t all = of.all ? of.all : there;
  std::int64_t rank = (all * of.percent + 99) / 100 - (all - there);
  for (std::size_t n = 0; n < bins.size() && rank > 0; ++n) {
    const auto bin = static_cast<std::int64_t>(bins[n]);
    if (rank <= bin) return std::int64_t(n) * of.width + (rank - 1) * of.width / bin;
    rank -= bin;
  }
  return 0;
}

}  // namespace

std::vector<std::string> sweep_columns(const engine& built) {
  std::vector<std::string> columns;
  for (const counter_info& counter : built.counters) columns.emplace_back(counter.name);
  for (const histogram_info& histogram : built.histograms) {
    columns.push_back(std::string(histogram.name) + ".sum");
    for (const Percentile& one : percentiles)
      if (std::string_view(histogram.name) == one.histogram) columns.push_back(one.column());
  }
  for (const line_info& line : built.lines)
    for (const char* part : {".sum", ".p99", ".max", ".never"})
      columns.push_back(std::string(line.name) + part);
  for (const char* name : sweep_kind(built).errors) columns.emplace_back(name);
  columns.emplace_back(PictureColumn);
  return columns;
}

std::vector<std::int64_t> column_values(const engine& built, const frame_counts& counts,
                                        std::vector<std::int64_t> errors,
                                        const std::vector<std::uint8_t>& colours) {
  std::vector<std::int64_t> values;
  for (const std::uint64_t counter : counts.counters)
    values.push_back(static_cast<std::int64_t>(counter));
  for (std::size_t n = 0; n < counts.histograms.size(); ++n) {
    values.push_back(sum_of(counts.histograms[n]));
    for (const Percentile& one : percentiles)
      if (std::string_view(built.histograms[n].name) == one.histogram)
        values.push_back(value_of(one, counts.histograms[n]));
  }
  for (const std::vector<int>& line : counts.lines) {
    Spread spread;
    std::int64_t never = 0;
    for (const int value : line)
      if (value < 0) ++never;
      else spread.add(value);
    const bool any = spread.count() > 0;
    values.push_back(static_cast<std::int64_t>(spread.sum()));
    values.push_back(any ? spread.percentile(99) : 0);
    values.push_back(any ? spread.max() : 0);
    values.push_back(never);
  }
  errors.resize(sweep_kind(built).errors.size());
  values.insert(values.end(), errors.begin(), errors.end());
  values.push_back(picture_digest({reinterpret_cast<const char*>(colours.data()), colours.size()}));
  return values;
}

NoValues::NoValues(const std::vector<std::string>& columns)
    : columns_(columns), sums_(columns.size()) {
  const auto place = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) -
                                    columns.begin());
  };
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::size_t dot = columns[i].rfind('.');
    if (dot == std::string::npos) continue;
    const std::string name = columns[i].substr(0, dot), part = columns[i].substr(dot);
    const Sum sum{place(name + ".sum"), place(name + ".never")};
    if ((part == ".p99" || part == ".max") && sum.column < columns.size() &&
        sum.never < columns.size())
      sums_[i] = sum;
  }
}

std::string NoValues::is_some(std::size_t column, const std::string& row) const {
  const Sum& sum = sums_[column];
  if (sum.never == 0) return "";
  return "(" + row + "." + quoted(columns_[sum.never]) + " = 0 OR " + row + "." +
         quoted(columns_[sum.column]) + " > 0)";
}

}  // namespace racebeam
