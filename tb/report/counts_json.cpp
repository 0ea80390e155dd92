// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/counts_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "sc/base/constants.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr int Percentile = 99;

Json json_of(const Spread& spread) {
  if (spread.count() == 0) return nullptr;
  return {{"min", spread.min()},
          {"mean", std::round(spread.mean() * 1000) / 1000},
          {"max", spread.max()},
          {"sum", spread.sum()}};
}

Json json_of(const LineSpread& line, const line_info& row, bool whole_run) {
  Json json = json_of(line.clocks);
  if (json.is_null() && !row.always) return json;
  if (json.is_null()) json = {{"min", nullptr}, {"mean", nullptr}, {"max", nullptr}, {"sum", 0}};
  if (*row.without) json[row.without] = line.without;
  if (!*row.title) return json;
  json["p99"] = line.clocks.percentile(Percentile);
  if (whole_run) json["worst_frame"] = line.worst_frame;
  json["worst_line"] = line.worst_line;
  return json;
}

}  // namespace

void LineSpread::add(int frame, const std::vector<int>& lines) {
  for (std::size_t n = 0; n < lines.size(); ++n) {
    if (lines[n] < 0) ++without;
    else clocks.add(lines[n]);
    if (lines[n] <= worst) continue;
    worst = lines[n];
    worst_frame = frame;
    worst_line = FirstVisibleLine + static_cast<int>(n);
  }
}

Json counts_json(const std::vector<counter_info>& counters,
                 const std::vector<histogram_info>& histograms, const knob_values& k,
                 const frame_counts& counts) {
  Json json = Json::object();
  for (std::size_t n = 0; n < counts.counters.size(); ++n)
    json[counters[n].name] = counts.counters[n];
  for (std::size_t n = 0; n < counts.histograms.size(); ++n) {
    std::vector<std::uint64_t> values = counts.histograms[n];
    values.resize(static_cast<std::size_t>(histograms[n].largest(k)) + 1);
    json[histograms[n].name] = values;
  }
  return json;
}

Json lines_json(const std::vector<line_info>& infos, const std::vector<LineSpread>& lines,
                bool whole_run) {
  Json json = Json::object();
  for (std::size_t n = 0; n < lines.size(); ++n)
    json[infos[n].name] = json_of(lines[n], infos[n], whole_run);
  return json;
}

}  // namespace racebeam
