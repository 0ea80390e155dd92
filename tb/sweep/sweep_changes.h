// What has changed in a sweep since it was run the last time: its points, the files of its scenes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "tb/sweep/store.h"
#include "tb/sweep/sweep_plan.h"

namespace racebeam {

/// A scene whose file is another one now.
struct OlderScene {
  std::int64_t id;
  std::string name;
  std::int64_t frames;  ///< results of a model that are of the file as it was
};

/// Which scenes the last run had; of others with the same name the file has changed since.
void keep_scenes(Store& store, const SweepPlan& plan);
/// Frames of a scene that may be taken, as the last run with it has said.
int population_of(const Store& store, const StoredScene& scene);
std::vector<OlderScene> older_scenes(Store& store, std::int64_t model);
/// "the scene house.toml has changed: 4,800 older results are of the other one", a line for each.
std::string scenes_text(const std::vector<OlderScene>& scenes);

/// The points of the last run, as a store has them until the plan's are put into it.
class FormerPoints {
 public:
  explicit FormerPoints(Store& store);
  /// "the sweep has changed: 2 points more, 1 point less, whose results are kept"; "": it has not,
  /// or has not been run. Points that a search asks for are not told.
  std::string change_to(const SweepPlan& plan) const;

 private:
  std::vector<StoredPoint> points_;  // that had a name
};

}  // namespace racebeam
