// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/stored_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/scene/engines.h"
#include "tb/show/open_show.h"
#include "tb/sweep/block_runner.h"
#include "tb/sweep/interval_text.h"
#include "tb/sweep/model_hash.h"
#include "tb/sweep/stored_setting.h"
#include "tb/sweep/sweep_kinds.h"

namespace racebeam {

namespace {

// Where error pixels stand, and the value that they have without the reference picture: a base's
// picture is not made again.
const std::set<std::string> OfReference = {"error_pixels", "visible_error_pixels"};

/// Compares what workers answer with what is stored.
class Comparer : public BlockRunner::Owner {
 public:
  Comparer(const Store& store, std::int64_t model, std::map<int, FrameKey> keys,
           std::map<int, std::string> names, std::string& report)
      : store_(store),
        columns_(store.frames.columns(model)),
        keys_(std::move(keys)),
        names_(std::move(names)),
        report_(report) {}

  void prepare(Block&) override {}
  void take(const Block& block, const std::vector<Answer>& answers) override {
    const std::vector<FrameRow> rows = store_.frames.read(keys_.at(block.number));
    for (const Answer& answer : answers) {
      ++repeated;
      const FrameRow& now = answer.frame.row;
      const auto row = std::find_if(rows.begin(), rows.end(),
                                    [&](const FrameRow& one) { return one.frame == now.frame; });
      for (std::size_t i = 0; i < columns_.size(); ++i) {
        if (block.reference == SweepReference::Base && OfReference.count(columns_[i])) continue;
        if (row->values[i] == now.values[i]) continue;
        good = false;
        report_ += fmt::format("frame {} of {} does not repeat: {} was {}, and is {}\n", now.frame,
                               names_.at(block.number), columns_[i], row->values[i], now.values[i]);
        break;
      }
    }
  }
  void fail(const Block& block, const std::string& reason, const std::string&) override {
    good = false;
    report_ += fmt::format("{}: {}\n", names_.at(block.number), reason);
  }
  void look() override {}

  int repeated = 0;
  bool good = true;

 private:
  const Store& store_;
  const std::vector<std::string> columns_;
  const std::map<int, FrameKey> keys_;
  const std::map<int, std::string> names_;
  std::string& report_;
};

// Why it is not what has been measured; "": it is.
std::string repeatable(const StoredScene& scene) try {
  return open_show(scene.name).hash() == scene.hash ? "" : " has changed";
} catch (const UsageError& error) {
  return std::string(" cannot be read (") + error.what() + ")";
}

}  // namespace

bool repeat_frames(Store& store, std::int64_t model, int sample, ForkServer& server, int jobs,
                   std::string& report) {
  std::string hash;
  for (const StoredModel& one : store.models())
    if (one.id == model) hash = one.hash;
  const engine* const built = engine_of_model(hash);
  if (!built) {
    report += fmt::format("measured by another model, {}: this program, {}, cannot repeat it\n",
                          hash, model_hash(engines().front()->name));
    return true;
  }
  std::map<std::int64_t, StoredScene> scenes;
  std::vector<std::pair<FrameKey, int>> stored;
  for (const StoredScene& scene : store.scenes()) {
    const auto there = store.frames.there(model, scene.id);
    if (there.empty()) continue;
    const std::string why = repeatable(scene);
    if (!why.empty()) {
      report += "the scene " + scene.name + why + ": its results cannot be repeated\n";
      continue;
    }
    scenes[scene.id] = scene;
    for (const auto& [point, frames] : there)
      for (const KeptFrame& frame : frames)
        stored.push_back({{model, scene.id, point}, frame.frame});
  }
  std::shuffle(stored.begin(), stored.end(), std::mt19937(std::random_device()()));
  stored.resize(std::min(stored.size(), static_cast<std::size_t>(sample)));

  std::map<std::int64_t, StoredPoint> points;
  for (const StoredPoint& point : store.points()) points[point.id] = point;
  std::map<std::pair<std::int64_t, std::int64_t>, Block> blocks;
  for (const auto& [key, frame] : stored) blocks[{key.scene, key.point}].frames.push_back(frame);
  std::list<Block> list;
  std::map<int, FrameKey> keys;
  std::map<int, std::string> names;
  for (auto& [of, block] : blocks) {
    const auto& [scene, point] = of;
    block.number = static_cast<int>(list.size()) + 1;
    keys[block.number] = {model, scene, point};
    names[block.number] = points[point].name.empty() ? "a point" : points[point].name;
    block.scene_name = scenes[scene].name;
    block.scene_hash = scenes[scene].hash;
    block.k = built->standard(nullptr);
    if (!read_setting(points[point].setting, block.k, block.reference)) {
      report += names[block.number] + " has knobs that this program does not know\n";
      return false;
    }
    block.base = block.k;  // whichever it was compared with, its own picture serves
    list.push_back(block);
  }
  Comparer comparer(store, model, keys, names, report);
  if (!BlockRunner(server, jobs, comparer).run(std::move(list))) throw Interrupted();
  report += fmt::format("{} measured again{}\n", counted(comparer.repeated, "stored frame"),
                        comparer.good ? ": all as they were" : "");
  return comparer.good;
}

}  // namespace racebeam
