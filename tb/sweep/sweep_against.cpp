// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_against.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/sweep/against_side.h"
#include "tb/sweep/interval_text.h"
#include "tb/sweep/sweep_kinds.h"

namespace racebeam {

namespace {

using Columns = std::vector<std::string>;

/// Rows of one scene that both have, side by side.
struct PairedRows {
  std::vector<FrameRow> now, before;
  int population = 0;

  bool differ() const {
    for (std::size_t i = 0; i < now.size(); ++i)
      if (now[i].values != before[i].values) return true;
    return false;
  }
};

int of_sample(const std::vector<FrameRow>& rows) {
  return static_cast<int>(
      std::count_if(rows.begin(), rows.end(), [](const FrameRow& row) { return !row.guard; }));
}

/// A guard frame of one of them is one here.
void pair_up(PairedRows& rows) {
  std::map<int, const FrameRow*> by_frame;
  for (const FrameRow& row : rows.before) by_frame[row.frame] = &row;
  PairedRows paired;
  for (FrameRow& row : rows.now) {
    const auto at = by_frame.find(row.frame);
    if (at == by_frame.end()) continue;
    FrameRow other = *at->second;
    row.guard = other.guard = row.guard || other.guard;
    paired.now.push_back(std::move(row));
    paired.before.push_back(std::move(other));
  }
  rows.now = std::move(paired.now);
  rows.before = std::move(paired.before);
}

/// What is compared, and the stored rows of it.
class Pairing {
 public:
  Pairing(const StoredSide& now, const StoredSide& before, std::vector<std::string>& notes)
      : now_(now), before_(before) {
    pair_scenes(notes);
    const SweepKind& kind = sweep_kind(now.built());
    compares_errors_ = now.reference() == before.reference();
    if (!compares_errors_)
      notes.push_back(
          fmt::format("pictures are compared with {} now, and were with {}: errors are "
                      "left out",
                      now.reference(), before.reference()));
    for (const std::string& column : now.columns())
      if (before.has_column(column) &&
          (compares_errors_ ||
           std::find(kind.errors.begin(), kind.errors.end(), column) == kind.errors.end()))
        columns_.push_back(column);
    for (const PointFigure& figure : figure_table()) {
      if (figure.kind == PointFigure::Exact) exact_.push_back(&figure);
      else if (figure.of_cause && compares_errors_) causes_.push_back(&figure);
      else if (!figure.of_cause && !figure.missing(columns_)) figures_.push_back(&figure);
    }
  }

  /// Frames and whether it has changed.
  AgainstPoint look(const PointPair& pair) const {
    AgainstPoint point;
    point.name = pair.now;
    point.name_before = pair.before;
    point.failure_now = now_.failure(pair.now);
    point.failure_before = before_.failure(pair.before);
    each_scene(pair, [&](const FrameKey& now, const FrameKey& before, int population) {
      PairedRows rows{now_.rows(now, columns_), before_.rows(before, columns_), population};
      point.frames_now += of_sample(rows.now);
      point.frames_before += of_sample(rows.before);
      pair_up(rows);
      point.frames += of_sample(rows.now);
      point.changed = point.changed || rows.differ();
      rows = causes(now, before, population);
      point.changed = point.changed || rows.differ();
    });
    for (const PointFigure* figure : exact_)
      if (const auto [now, before] = exact(pair, *figure); now != before) point.changed = true;
    return point;
  }

  std::vector<ChangedFigure> changes(const PointPair& pair, double confidence) const {
    std::map<const PointFigure*, std::pair<Strata, Strata>> strata;
    const auto read = [&strata](const std::vector<const PointFigure*>& figures,
                                const Columns& columns, const PairedRows& rows) {
      if (rows.now.empty()) return;
      for (const PointFigure* figure : figures) {
        const FigureReader reader(*figure, columns);
        auto& [now, before] = strata[figure];
        Stratum one = reader.stratum(rows.now, rows.population);
        if (one.frames.empty()) continue;
        now.push_back(std::move(one));
        before.push_back(reader.stratum(rows.before, rows.population));
      }
    };
    each_scene(pair, [&](const FrameKey& now, const FrameKey& before, int population) {
      PairedRows rows{now_.rows(now, columns_), before_.rows(before, columns_), population};
      pair_up(rows);
      read(figures_, columns_, rows);
      read(causes_, cause_columns(), causes(now, before, population));
    });
    std::vector<ChangedFigure> changed;
    for (const PointFigure& figure : figure_table()) {
      if (figure.kind == PointFigure::Exact) {
        const auto [now, before] = exact(pair, figure);
        if (now != before) changed.push_back({&figure, before, now, {now - before, 0, 1, 1}});
      } else if (const auto at = strata.find(&figure); at != strata.end()) {
        const auto& [now, before] = at->second;
        if (!same(now, before)) changed.push_back(change(figure, now, before, confidence));
      }
    }
    return changed;
  }

 private:
  void pair_scenes(std::vector<std::string>& notes) {
    std::set<std::string> changed;
    for (const StoredScene& now : now_.scenes())
      for (const StoredScene& before : before_.scenes())
        if (now.hash == before.hash) {
          scenes_.push_back(
              {now.id, before.id, std::min(now_.population(now), before_.population(before))});
          changed.erase(now.name);
        } else if (now.name == before.name) {
          changed.insert(now.name);
        }
    for (const std::string& name : changed)
      notes.push_back("the scene " + name + " is another one than before: it is left out");
  }

  template <class Look>
  void each_scene(const PointPair& pair, const Look& look) const {
    for (const auto& [id_now, id_before] : pair.ids)
      for (const Scenes& scene : scenes_)
        look(now_.key(scene.now, id_now), before_.key(scene.before, id_before), scene.population);
  }

  Columns cause_columns() const {
    Columns names;
    for (const PointFigure* figure : causes_) names.push_back(figure->terms.front().column);
    return names;
  }

  PairedRows causes(const FrameKey& now, const FrameKey& before, int population) const {
    if (causes_.empty()) return {};
    PairedRows rows{now_.causes(now, cause_columns()), before_.causes(before, cause_columns()),
                    population};
    pair_up(rows);
    return rows;
  }

  /// Now and before; the same if one of them does not have it.
  std::pair<double, double> exact(const PointPair& pair, const PointFigure& figure) const {
    for (const auto& [id_now, id_before] : pair.ids) {
      const auto now = now_.exact(id_now, figure.name),
                 before = before_.exact(id_before, figure.name);
      if (now && before) return {*now, *before};
    }
    return {0, 0};
  }

  static bool same(const Strata& now, const Strata& before) {
    for (std::size_t i = 0; i < now.size(); ++i)
      if (now[i].values != before[i].values) return false;
    return true;
  }

  static ChangedFigure change(const PointFigure& figure, const Strata& now, const Strata& before,
                              double confidence) {
    if (figure.sampled())
      return {&figure, mean_of(before).value, mean_of(now).value,
              difference_of(now, before, confidence)};
    const Worst worst = worst_of(now), worst_before = worst_of(before);
    return {&figure,
            worst_before.value,
            worst.value,
            {worst.value - worst_before.value, 0, worst.frames, worst.frames}};
  }

  struct Scenes {
    std::int64_t now, before;
    int population;
  };
  const StoredSide& now_;
  const StoredSide& before_;
  std::vector<Scenes> scenes_;
  Columns columns_;
  std::vector<const PointFigure*> figures_, causes_, exact_;
  bool compares_errors_ = true;
};

void require(bool there, const AgainstSide& now, const AgainstSide& before, const std::string& what,
             const std::vector<std::string>& notes = {}) {
  if (there) return;
  std::string why;
  for (const std::string& note : notes) why += "; " + note;
  throw UsageError(fmt::format("{} and {} have no {} in common: there is nothing to compare{}",
                               now.folder, before.folder, what, why));
}

}  // namespace

int SweepAgainst::changed() const {
  return static_cast<int>(std::count_if(points.begin(), points.end(),
                                        [](const AgainstPoint& one) { return one.changed; }));
}

int SweepAgainst::failed() const {
  return static_cast<int>(std::count_if(points.begin(), points.end(), [](const AgainstPoint& one) {
    return one.failure_now.empty() != one.failure_before.empty();
  }));
}

SweepAgainst sweep_against(const std::string& folder, const std::string& former) {
  std::error_code ignored;
  const bool same_folder = std::filesystem::equivalent(folder, former, ignored);
  StoredSide now(folder);
  StoredSide before(former, same_folder ? now.model().id : 0);
  SweepAgainst against{
      {folder, now.model(), {}}, {former, before.model(), {}}, &now.built(), {}, {}};
  if (&now.built() != &before.built())
    throw UsageError(fmt::format("{} is of {} and {} is of {}: there is nothing to compare", folder,
                                 now.built().name, former, before.built().name));
  const std::vector<PointPair> pairs =
      paired_points(now, before, against.now.alone, against.before.alone);
  require(!pairs.empty(), against.now, against.before, "point");
  const Pairing pairing(now, before, against.notes);
  int frames = 0;
  for (const PointPair& pair : pairs) {
    against.points.push_back(pairing.look(pair));
    against.points.back().setting = now.setting_words(pair);
    frames += against.points.back().frames;
  }
  require(frames > 0, against.now, against.before, "frame of a point", against.notes);
  const double confidence = for_best_of(std::max(1, against.changed()));
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (against.points[i].changed)
      against.points[i].figures = pairing.changes(pairs[i], confidence);
  return against;
}

}  // namespace racebeam
