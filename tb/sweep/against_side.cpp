// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/against_side.h"

#include <algorithm>
#include <set>

#include "tb/base/errors.h"
#include "tb/sweep/exact_figures.h"
#include "tb/sweep/schema.h"
#include "tb/sweep/sweep_changes.h"
#include "tb/sweep/sweep_kinds.h"

namespace racebeam {

namespace {

bool is_reference(const std::string& name) { return name.rfind("reference", 0) == 0; }

const knob_row* row_of(const engine& built, const std::string& name) {
  for (const knob_row& row : built.knobs)
    if (row.name == name) return &row;
  return nullptr;
}

// Whose knobs they are: of a model that is not this program's, the engine that knows most of them.
const engine& engine_with(const std::vector<StoredPoint>& points) {
  const engine* best = nullptr;
  std::ptrdiff_t most = -1;
  for (const SweepKind& kind : sweep_kinds()) {
    std::ptrdiff_t known = 0;
    if (!points.empty())
      for (const auto& [name, value] : StoredSide::knobs_of(points.front()))
        known += row_of(kind.engine, name) != nullptr;
    if (known > most) {
      best = &kind.engine;
      most = known;
    }
  }
  return *best;
}

StoredModel model_beside(Store& store, std::int64_t other, const std::string& folder) {
  StoredModel found;
  const std::int64_t shown = shown_model(store);
  for (const StoredModel& one : store.models())
    if (other ? one.id != other && store.frames.count(one.id) > 0 : one.id == shown) found = one;
  if (found.id == 0)
    throw UsageError(other ? folder +
                                 " has results of one model only; name another folder with "
                                 "--against, or measure with another model: sweep run --fresh"
                           : folder + " has no results yet; run the sweep first");
  return found;
}

std::set<std::string> knob_names(const StoredSide& side) {
  std::set<std::string> names;
  for (const StoredPoint& point : side.points())
    for (const auto& [name, value] : StoredSide::knobs_of(point)) names.insert(name);
  return names;
}

// What points are paired by: knobs that `other` does not know and that have their default are none.
std::string pair_key(const StoredSide& side, const StoredPoint& point,
                     const std::set<std::string>& other) {
  std::string key;
  for (const auto& [name, value] : StoredSide::knobs_of(point))
    if (other.count(name) || side.standard(name) != value) key += name + "=" + value + "\n";
  return key;
}

}  // namespace

StoredSide::StoredSide(const std::string& folder, std::int64_t other)
    : folder_(folder),
      store_(folder_.store(), Access::Read),
      model_(model_beside(store_, other, folder)),
      scenes_(store_.scenes()) {
  for (const StoredPoint& point : store_.points())
    if (!point.name.empty()) points_.push_back(point);
  built_ = engine_of_model(model_.hash);
  if (!built_) built_ = &engine_with(points_);
  std::map<std::int64_t, std::string> names;
  for (const StoredPoint& point : points_) names[point.id] = point.name;
  for (const Failure& failure : store_.failures.all(model_.id))
    failures_[names[failure.key.point]] = failure.reason;
  for (const ExactFigure& one : kept_exact(store_, model_.id))
    exact_[{one.point, one.figure}] = one.value;
}

int StoredSide::population(const StoredScene& scene) const { return population_of(store_, scene); }

bool StoredSide::has_column(const std::string& name) const {
  return std::find(columns().begin(), columns().end(), name) != columns().end();
}

std::string StoredSide::reference() const {
  for (const StoredPoint& point : points_)
    for (const auto& [name, value] : setting_of(point.setting))
      if (name == "reference") return value;
  return "";
}

std::map<std::string, std::string> StoredSide::knobs_of(const StoredPoint& point) {
  std::map<std::string, std::string> knobs;
  for (const auto& [name, value] : setting_of(point.setting))
    if (!is_reference(name)) knobs[name] = value;
  return knobs;
}

std::optional<std::string> StoredSide::standard(const std::string& knob) const {
  const knob_row* const row = row_of(*built_, knob);
  if (!row) return {};
  return row->text(row->standard);
}

std::string StoredSide::setting_words(const PointPair& pair) const {
  std::string words;
  const auto point = std::find_if(points_.begin(), points_.end(), [&](const StoredPoint& one) {
    return one.id == pair.ids.front().first;
  });
  for (const auto& [name, value] : knobs_of(*point)) {
    const knob_row* const row = row_of(*built_, name);
    if ((row && row->of_scene) || standard(name) == value) continue;
    words += (words.empty() ? "" : " ") + name + "=" + value;
  }
  return words;
}

std::string StoredSide::failure(const std::string& point) const {
  const auto at = failures_.find(point);
  return at == failures_.end() ? "" : at->second;
}

std::optional<double> StoredSide::exact(std::int64_t point, const std::string& figure) const {
  const auto at = exact_.find({point, figure});
  if (at == exact_.end()) return {};
  return at->second;
}

std::vector<PointPair> paired_points(const StoredSide& now, const StoredSide& before,
                                     std::vector<std::string>& alone_now,
                                     std::vector<std::string>& alone_before) {
  const std::set<std::string> known_now = knob_names(now), known_before = knob_names(before);
  std::map<std::string, const StoredPoint*> by_key;
  for (const StoredPoint& point : before.points())
    by_key[pair_key(before, point, known_now)] = &point;
  std::vector<PointPair> pairs;
  std::map<std::pair<std::string, std::string>, std::size_t> places;
  std::set<std::string> paired_now, paired_before;
  for (const StoredPoint& point : now.points()) {
    const auto found = by_key.find(pair_key(now, point, known_before));
    if (found == by_key.end()) continue;
    const StoredPoint& other = *found->second;
    const auto [at, is_new] = places.try_emplace({point.name, other.name}, pairs.size());
    if (is_new) pairs.push_back({point.name, other.name});
    pairs[at->second].ids.emplace_back(point.id, other.id);
    paired_now.insert(point.name);
    paired_before.insert(other.name);
  }
  const auto alone = [](const StoredSide& side, const std::set<std::string>& paired,
                        std::vector<std::string>& names) {
    std::set<std::string> seen = paired;
    for (const StoredPoint& point : side.points())
      if (seen.insert(point.name).second) names.push_back(point.name);
  };
  alone(now, paired_now, alone_now);
  alone(before, paired_before, alone_before);
  return pairs;
}

}  // namespace racebeam
