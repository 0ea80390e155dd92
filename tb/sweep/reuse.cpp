// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/reuse.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "tb/base/errors.h"
#include "tb/sweep/model_hash.h"
#include "tb/sweep/sweep_folder.h"

namespace racebeam {

namespace {

std::int64_t model_in(Store& other, const std::string& path, const std::string& hash) {
  const std::vector<StoredModel> models = other.models();
  for (const StoredModel& one : models)
    if (one.hash == hash) return one.id;
  throw UsageError(
      fmt::format("{} has results of the model {}, and this program is {}: leave out "
                  "--reuse {}",
                  path, models.empty() ? "none" : models.back().hash, hash, path));
}

}  // namespace

std::int64_t reuse_results(Store& store, std::int64_t model, const SweepPlan& plan,
                           const std::vector<std::string>& folders) {
  std::vector<StoredPoint> points;
  for (const PlannedPoint& point : plan.points)
    for (const std::string& setting : point.settings) points.push_back({setting, point.point.name});
  const std::vector<std::int64_t> ids = store.points(points);
  std::int64_t frames = 0;
  for (const std::string& path : folders) {
    const SweepFolder folder(path, Access::Read);
    if (!std::filesystem::exists(folder.store()))
      throw UsageError(path + " is not the folder of a sweep: it has no sweep.sqlite");
    Store other(folder.store(), Access::Read);
    const std::int64_t from_model =
        model_in(other, path, model_hash(plan.scenes.front().show.engine().name));
    std::map<std::string, std::int64_t> from_points;
    for (const StoredPoint& point : other.points()) from_points[point.setting] = point.id;
    std::map<std::string, std::int64_t> from_scenes;
    for (const StoredScene& scene : other.scenes()) from_scenes[scene.hash] = scene.id;
    for (std::size_t at = 0; at < points.size(); ++at) {
      const auto& [name, show, order] = plan.scenes[at % plan.scenes.size()];
      const auto point = from_points.find(points[at].setting);
      const auto scene = from_scenes.find(show.hash());
      if (point == from_points.end() || scene == from_scenes.end()) continue;
      const FrameKey key{model, store.scene({name, show.hash(), show.frames()}), ids[at]};
      frames +=
          store.frames.take_over(key, other.frames, {from_model, scene->second, point->second});
    }
  }
  return frames;
}

}  // namespace racebeam
