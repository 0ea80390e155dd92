// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_changes.h"

#include <fmt/format.h>

#include <algorithm>

#include "tb/base/counted.h"
#include "tb/scene/engines.h"
#include "tb/sweep/interval_text.h"
#include "tb/sweep/schema.h"

namespace racebeam {

namespace {

constexpr const char* Scenes = "scenes";  // hashes, one a line

std::string population_note(const std::string& scene) { return "frames to take of " + scene; }

// Without the knobs that a scene sets: they are no change of the sweep.
std::string own_setting(const std::string& setting) {
  std::string own;
  for (const auto& [name, value] : setting_of(setting)) {
    bool of_scene = false;
    for (const engine* one : engines())
      for (const knob_row& row : one->knobs) of_scene |= row.of_scene && row.name == name;
    if (!of_scene) own += name + "=" + value + "\n";
  }
  return own;
}

}  // namespace

void keep_scenes(Store& store, const SweepPlan& plan) {
  std::string hashes;
  for (const SweepScene& scene : plan.scenes) hashes += scene.show.hash() + "\n";
  if (hashes != store.notes.find(Scenes)) store.notes.put(Scenes, hashes);
  for (const SweepScene& scene : plan.scenes) {
    const std::string note = population_note(scene.show.hash()),
                      count = std::to_string(scene.order.size());
    if (count != store.notes.find(note)) store.notes.put(note, count);
  }
}

int population_of(const Store& store, const StoredScene& scene) {
  const std::string count = store.notes.find(population_note(scene.hash));
  return count.empty() ? static_cast<int>(scene.frames) : std::stoi(count);
}

std::vector<OlderScene> older_scenes(Store& store, std::int64_t model) {
  const std::vector<std::string> last = lines_of(store.notes.find(Scenes));
  const auto is_last = [&last](const StoredScene& scene) {
    return std::find(last.begin(), last.end(), scene.hash) != last.end();
  };
  const std::vector<StoredScene> scenes = store.scenes();
  std::vector<OlderScene> older;
  for (const StoredScene& scene : scenes) {
    const bool changed =
        !is_last(scene) && std::any_of(scenes.begin(), scenes.end(), [&](const StoredScene& other) {
          return is_last(other) && other.name == scene.name;
        });
    if (!changed) continue;
    std::int64_t frames = 0;
    for (const auto& [point, kept] : store.frames.there(model, scene.id))
      frames += static_cast<std::int64_t>(kept.size());
    older.push_back({scene.id, scene.name, frames});
  }
  return older;
}

std::string scenes_text(const std::vector<OlderScene>& scenes) {
  std::string text;
  for (const OlderScene& scene : scenes)
    if (scene.frames > 0)
      text += fmt::format("the scene {} has changed: {} older results are of the other one\n",
                          scene.name, grouped(scene.frames));
  return text;
}

FormerPoints::FormerPoints(Store& store) {
  for (StoredPoint& point : store.points())
    if (!point.name.empty()) points_.push_back(std::move(point));
}

std::string FormerPoints::change_to(const SweepPlan& plan) const {
  if (points_.empty()) return "";
  std::set<std::string> before, now, gone;
  std::size_t more = 0;
  for (const StoredPoint& point : points_) before.insert(own_setting(point.setting));
  for (const PlannedPoint& point : plan.points) {
    bool is_new = true;
    for (const std::string& setting : point.settings) {
      const std::string own = own_setting(setting);
      now.insert(own);
      is_new = is_new && before.count(own) == 0;
    }
    more += is_new && !plan.file.search.adapts();
  }
  for (const StoredPoint& point : points_)
    if (now.count(own_setting(point.setting)) == 0) gone.insert(point.name);
  if (more == 0 && gone.empty()) return "";
  return "the sweep has changed: " + (more ? counted(more, "point") + " more" : "") +
         (more && !gone.empty() ? ", " : "") +
         (gone.empty() ? "" : counted(gone.size(), "point") + " less, whose results are kept");
}

}  // namespace racebeam
