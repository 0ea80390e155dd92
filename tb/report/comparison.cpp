// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/show/open_show.h"
#include "tb/show/run.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

/// Those of "E.knob=value" that are for an engine.
std::vector<std::string> settings_of(const engine& built, const std::vector<std::string>& all) {
  std::vector<std::string> own;
  const std::string begin = std::string(built.name) + ".";
  for (const std::string& one : all)
    if (one.compare(0, begin.size(), begin) == 0) own.push_back(one.substr(begin.size()));
  return own;
}

ComparedEngine compare_engine(const engine& built, const CompareGroup& group,
                              const CompareSetting& setting) {
  ComparedEngine column{built.name, ""};
  for (const CompareScene& scene : group.scenes) {
    std::string why;
    const std::optional<Show> show = open_show_for(built, scene.scene, why);
    if (!show) {
      if (column.why.empty()) column.why = why;
      continue;
    }
    std::vector<std::string> assignments = settings_of(built, scene.settings);
    for (const std::string& one : settings_of(built, setting.assignments))
      assignments.push_back(one);
    const knob_values k = knobs_of(*show, assignments);
    column.why = "";
    column.cell = ComparedCell::of_bytes(
        forked([&] { return measure_cell(*show, k, scene.first, setting.pictures).bytes(); }));
    return column;
  }
  return column;
}

std::string figure_text(const CompareMetric& metric, const std::optional<double>& value) {
  if (!value) return "-";
  if (std::isinf(*value)) return "exact";
  return fmt::format("{:.{}f}", *value, metric.decimals);
}

/// Of each figure a row: its title, and a text for each engine.
std::vector<std::vector<std::string>> rows_of(const ComparedGroup& group) {
  std::vector<std::vector<std::string>> rows(1, {group.name});
  for (const ComparedEngine& column : group.engines)
    rows.front().push_back(column.cell ? column.engine + " " + column.cell->scene : column.engine);
  const auto& metrics = compare_metrics();
  for (std::size_t n = 0; n < metrics.size(); ++n) {
    const std::string unit = metrics[n].unit;
    rows.push_back({metrics[n].title + (unit.empty() ? "" : ", " + unit)});
    for (const ComparedEngine& column : group.engines)
      rows.back().push_back(column.cell ? figure_text(metrics[n], column.cell->metrics[n]) : "-");
  }
  return rows;
}

/// A sentence for each engine: why it draws nothing, or with which knobs it does.
std::vector<std::string> remarks_of(const ComparedGroup& group) {
  std::vector<std::string> remarks;
  for (const ComparedEngine& column : group.engines)
    if (!column.cell) remarks.push_back(column.engine + " does not draw it: " + column.why);
    else if (column.cell->first > 0 || column.cell->knobs != "default")
      remarks.push_back(fmt::format("{}: from picture {} on; knobs: {}", column.engine,
                                    column.cell->first, column.cell->knobs));
  return remarks;
}

Json value_of(const std::optional<double>& value) {
  if (!value) return nullptr;
  if (std::isinf(*value)) return "infinite";
  return *value;
}

Json json_of(const ComparedEngine& column) {
  if (!column.cell) return {{"engine", column.engine}, {"why", column.why}};
  const ComparedCell& cell = *column.cell;
  Json quantities = Json::object(), figures = Json::object();
  for (const ComparedCell::Quantity& row : cell.quantities)
    quantities[row.name] = {{"formula", row.formula}, {"value", value_of(row.value)}};
  for (std::size_t n = 0; n < cell.metrics.size(); ++n)
    figures[compare_metrics()[n].name] = value_of(cell.metrics[n]);
  return {{"engine", cell.engine}, {"scene", cell.scene},     {"first", cell.first},
          {"knobs", cell.knobs},   {"numbers", cell.numbers}, {"quantities", quantities},
          {"figures", figures}};
}

Json names_json(const std::vector<CompareName>& names) {
  Json json = Json::object();
  for (const CompareName& row : names) json[row.name] = row.meaning;
  return json;
}

}  // namespace

const std::vector<CompareGroup>& common_groups() {
  static const std::vector<std::string> block = {"block.cores=1", "block.size=512x480"};
  static const std::vector<CompareGroup> groups = {
      {"own scenes",
       {{"voxel/hills"}, {"demo", 5000}, {"sphere/four"}, {"block/forty", 0, {"block.cores=1"}}}},
      {"common/hall", {{"common/hall", 0, {"voxel.leaf=voxel"}}}},
      {"common/balls", {{"common/balls", 0, block}}},
      {"common/rising-1", {{"common/rising-1", 0, block}}},
      {"common/rising-2", {{"common/rising-2", 0, block}}},
      {"common/rising-4", {{"common/rising-4", 0, block}}},
      {"common/rising-8", {{"common/rising-8", 0, block}}},
      {"common/rising-15", {{"common/rising-15", 0, block}}},
  };
  return groups;
}

ComparedGroup compare_group(const CompareGroup& group, const CompareSetting& setting) {
  ComparedGroup compared{group.name, {}};
  for (const engine* built : setting.engines)
    compared.engines.push_back(compare_engine(*built, group, setting));
  if (std::any_of(compared.engines.begin(), compared.engines.end(),
                  [](const ComparedEngine& column) { return column.cell.has_value(); }))
    return compared;
  std::string why;
  for (const std::string& remark : remarks_of(compared)) why += "\n  " + remark;
  throw UsageError("no engine draws " + group.name + why);
}

std::string compared_text(const ComparedGroup& group) {
  const auto rows = rows_of(group);
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows)
    for (std::size_t n = 0; n < row.size(); ++n) widths[n] = std::max(widths[n], row[n].size());
  std::string text;
  for (const auto& row : rows) {
    text += fmt::format("{:<{}}", row[0], widths[0]);
    for (std::size_t n = 1; n < row.size(); ++n) text += fmt::format("  {:>{}}", row[n], widths[n]);
    text += "\n";
  }
  for (const std::string& remark : remarks_of(group)) text += remark + "\n";
  return text;
}

std::string compared_markdown(const ComparedGroup& group) {
  const auto rows = rows_of(group);
  std::string text;
  for (const auto& row : rows) {
    text += "|";
    for (const std::string& word : row) text += " " + word + " |";
    text += "\n";
    if (&row != &rows.front()) continue;
    text += "|---|";
    for (std::size_t n = 1; n < row.size(); ++n) text += "--:|";
    text += "\n";
  }
  const auto remarks = remarks_of(group);
  if (!remarks.empty()) text += "\n";
  for (const std::string& remark : remarks) text += "- " + remark + "\n";
  return text;
}

std::string compared_json(const std::vector<ComparedGroup>& groups) {
  Json figures = Json::array(), all = Json::array();
  for (const CompareMetric& metric : compare_metrics())
    figures.push_back({{"name", metric.name},
                       {"title", metric.title},
                       {"unit", metric.unit},
                       {"meaning", metric.meaning},
                       {"formula", metric.formula},
                       {"measured", metric.measured}});
  for (const ComparedGroup& group : groups) {
    Json engines = Json::array();
    for (const ComparedEngine& column : group.engines) engines.push_back(json_of(column));
    all.push_back({{"name", group.name}, {"engines", engines}});
  }
  return Json{{"schema", "racebeam-compare"},
              {"version", 1},
              {"figures", figures},
              {"numbers", names_json(compare_numbers())},
              {"quantities", names_json(compare_quantities())},
              {"groups", all}}
             .dump(1) +
         "\n";
}

}  // namespace racebeam
