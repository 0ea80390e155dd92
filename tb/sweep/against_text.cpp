// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "tb/base/counted.h"
#include "tb/sweep/aligned_rows.h"
#include "tb/sweep/interval_text.h"
#include "tb/sweep/sweep_against.h"
#include "tb/sweep/sweep_kinds.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t MostNames = 8, MostPoints = 40, MostOfOthers = 3, HashDigits = 8;

// Those that a table has, if one of them has changed; the others are told by name.
bool is_shown(const PointFigure& figure, const engine& built) {
  const auto& shown = sweep_kind(built).shown;
  return figure.kind == PointFigure::Exact ||
         std::any_of(shown.begin(), shown.end(),
                     [&](const char* name) { return figure.name == name; });
}

std::string change_text(const ChangedFigure& changed) {
  const PointFigure& figure = *changed.figure;
  const std::string unit = figure.kind == PointFigure::Percent ? "points" : figure.unit,
                    sign = changed.change.value > 0 ? "+" : "";
  if (!figure.sampled()) return sign + text_of(changed.change.value, unit);
  return sign + text_of(changed.change, unit) +
         (!changed.surely()         ? ": not surely"
          : changed.change.so_far() ? ", so far"
                                    : "");
}

std::string names_text(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), MostNames); ++i)
    text += (i ? ", " : "") + names[i];
  if (names.size() > MostNames) text += fmt::format(" and {} more", names.size() - MostNames);
  return text;
}

std::string model_text(const StoredModel& model) {
  return fmt::format("{} (racebeam {}, commit {})", model.hash.substr(0, HashDigits), model.version,
                     model.commit);
}

std::string head(const SweepAgainst& against) {
  const StoredModel &now = against.now.model, &before = against.before.model;
  return fmt::format("{} against {}: {}\n", against.now.folder, against.before.folder,
                     now.hash == before.hash
                         ? "the same model, " + model_text(now)
                         : "model " + model_text(now) + " against " + model_text(before));
}

void add_rows(const AgainstPoint& point, const engine& built, std::vector<TextRow>& rows,
              std::string& others) {
  const bool any =
      std::any_of(point.figures.begin(), point.figures.end(),
                  [&](const ChangedFigure& changed) { return is_shown(*changed.figure, built); });
  std::vector<std::string> hidden;
  const std::size_t before = rows.size();
  for (const ChangedFigure& changed : point.figures) {
    const bool has_row =
        any ? is_shown(*changed.figure, built) : rows.size() < before + MostOfOthers;
    if (!has_row) {
      hidden.push_back(changed.figure->name);
      continue;
    }
    const bool first = rows.size() == before;
    rows.push_back({first ? point.name : "", first ? grouped(point.frames) : "",
                    changed.figure->name, text_of(changed.before), text_of(changed.now),
                    change_text(changed), first ? point.setting : ""});
  }
  if (rows.size() == before)
    rows.push_back({point.name, grouped(point.frames), "", "", "", "", point.setting});
  if (!hidden.empty()) others += fmt::format("{}: also {}\n", point.name, names_text(hidden));
  else if (point.figures.empty())
    others += point.name + ": no figure, but counters or pixels that none of them tells\n";
}

std::string table(const SweepAgainst& against) {
  std::vector<TextRow> rows = {{"point", "frames", "figure", "before", "now", "change"}};
  std::string others;
  std::size_t shown = 0, changed = 0;
  for (const AgainstPoint& point : against.points) {
    if (!point.changed || ++changed > MostPoints) continue;
    add_rows(point, *against.built, rows, others);
    ++shown;
  }
  if (shown == 0) return "";
  if (changed > shown) others += fmt::format("... and {} more\n", changed - shown);
  return aligned(rows) + others;
}

std::string failures(const SweepAgainst& against) {
  std::string text;
  for (const AgainstPoint& point : against.points) {
    if (!point.failure_now.empty())
      text += fmt::format("failed: {}: {}{}\n", point.name, point.failure_now,
                          point.failure_before.empty() ? "; it had been measured" : "");
    else if (!point.failure_before.empty())
      text += fmt::format("measured: {}, which had failed: {}\n", point.name, point.failure_before);
  }
  return text;
}

// That of some points only a part is compared.
std::string partly(const SweepAgainst& against) {
  std::size_t points = 0, without = 0;
  int least = 0, most = 0;
  for (const AgainstPoint& point : against.points) {
    const int all = std::max(point.frames_now, point.frames_before);
    if (point.frames == 0 && point.failure_now.empty() && point.failure_before.empty()) ++without;
    if (point.frames == 0 || point.frames == all) continue;
    if (points == 0 || point.frames < least) {
      least = point.frames;
      most = all;
    }
    ++points;
  }
  std::string text;
  if (points > 0)
    text += fmt::format(
        "of {} one side has more frames: those that both have are compared, {} of "
        "{} at least\n",
        counted(points, "point"), grouped(least), grouped(most));
  if (without > 0) text += counted(without, "point") + " without a frame that both have\n";
  return text;
}

Json json_of(const AgainstSide& side) {
  return {{"folder", side.folder},
          {"model", side.model.hash},
          {"version", side.model.version},
          {"commit", side.model.commit},
          {"points_alone", side.alone}};
}

Json json_of(const ChangedFigure& changed) {
  const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
  return {{"figure", changed.figure->name},
          {"unit", changed.figure->unit},
          {"before", number(changed.before)},
          {"now", number(changed.now)},
          {"change", number(changed.change.value)},
          {"half_width", number(changed.change.half_width)},
          {"surely", changed.surely()}};
}

}  // namespace

std::string against_text(const SweepAgainst& against) {
  const int changed = against.changed(), count = static_cast<int>(against.points.size());
  const int compared = static_cast<int>(
      std::count_if(against.points.begin(), against.points.end(),
                    [](const AgainstPoint& point) { return point.frames > 0 || point.changed; }));
  std::string text = head(against);
  for (const std::string& note : against.notes) text += note + "\n";
  text += partly(against);
  if (changed > 0)
    text += fmt::format(
        "{} of {} changed{}:\n", changed, counted(count, "point"),
        changed > 1 ? fmt::format(" (intervals of 95 % for {} together)", changed) : "");
  text += table(against);
  if (changed == 0) text += fmt::format("none of {} changed: ", counted(count, "point"));
  if (compared > changed)
    text += fmt::format("{} are the same in every frame that both have\n", compared - changed);
  for (const auto& [side, when] :
       {std::make_pair(&against.now, "now"), {&against.before, "before"}})
    if (!side->alone.empty())
      text += fmt::format("{} only {}: {}\n", counted(side->alone.size(), "point"), when,
                          names_text(side->alone));
  return text + failures(against);
}

std::string against_json(const SweepAgainst& against) {
  Json points = Json::array();
  for (const AgainstPoint& point : against.points) {
    Json figures = Json::array();
    for (const ChangedFigure& changed : point.figures) figures.push_back(json_of(changed));
    points.push_back({{"point", point.name},
                      {"point_before", point.name_before},
                      {"setting", point.setting},
                      {"changed", point.changed},
                      {"frames", point.frames},
                      {"frames_now", point.frames_now},
                      {"frames_before", point.frames_before},
                      {"failure_now", point.failure_now},
                      {"failure_before", point.failure_before},
                      {"figures", figures}});
  }
  const Json json = {{"schema", "racebeam-sweep-against"},
                     {"version", 1},
                     {"same", against.same()},
                     {"changed", against.changed()},
                     {"now", json_of(against.now)},
                     {"before", json_of(against.before)},
                     {"notes", against.notes},
                     {"points", points}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace racebeam
