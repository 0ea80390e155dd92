// StoredSide: one of two sweeps that are held against each other, as its store has it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sc/base/engine.h"
#include "tb/sweep/begun_folder.h"
#include "tb/sweep/store.h"

namespace racebeam {

/// A point that both have. Scenes with other knobs of their own give it a setting each.
struct PointPair {
  std::string now, before;                                   ///< names
  std::vector<std::pair<std::int64_t, std::int64_t>> ids{};  ///< of their stores
};

class StoredSide {
 public:
  /// The model of a folder whose results are shown, or, beside `other`, the last one that is not
  /// that. Throws UsageError if there is none.
  explicit StoredSide(const std::string& folder, std::int64_t other = 0);

  const StoredModel& model() const { return model_; }
  /// Whose knobs its points have.
  const engine& built() const { return *built_; }
  const std::vector<StoredScene>& scenes() const { return scenes_; }
  int population(const StoredScene& scene) const;
  const std::vector<std::string>& columns() const { return store_.frames.columns(model_.id); }
  bool has_column(const std::string& name) const;
  /// What its pictures are compared with: "geometry".
  std::string reference() const;

  /// Those with a name, as they came.
  const std::vector<StoredPoint>& points() const { return points_; }
  /// Knobs and values of a point, without what pictures are compared with.
  static std::map<std::string, std::string> knobs_of(const StoredPoint& point);
  /// The default of a knob of this program; nothing if there is none of that name.
  std::optional<std::string> standard(const std::string& knob) const;
  /// The knobs of a pair that are not as by default.
  std::string setting_words(const PointPair& pair) const;

  FrameKey key(std::int64_t scene, std::int64_t point) const { return {model_.id, scene, point}; }
  std::vector<FrameRow> rows(const FrameKey& key, const std::vector<std::string>& columns) const {
    return store_.frames.read(key, columns);
  }
  std::vector<FrameRow> causes(const FrameKey& key, const std::vector<std::string>& causes) const {
    return store_.frames.read_causes(key, causes);
  }
  /// Why a point could not be measured, by name; "": it could.
  std::string failure(const std::string& point) const;
  std::optional<double> exact(std::int64_t point, const std::string& figure) const;

 private:
  const BegunFolder folder_;
  Store store_;
  StoredModel model_;
  const engine* built_ = nullptr;
  std::vector<StoredScene> scenes_;
  std::vector<StoredPoint> points_;
  std::map<std::string, std::string> failures_;
  std::map<std::pair<std::int64_t, std::string>, double> exact_;
};

/// Points that both have, in the order of `now`; the names of those that one has alone.
std::vector<PointPair> paired_points(const StoredSide& now, const StoredSide& before,
                                     std::vector<std::string>& alone_now,
                                     std::vector<std::string>& alone_before);

}  // namespace racebeam
