// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_status.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tb/base/errors.h"
#include "tb/base/output_file.h"
#include "tb/sweep/begun_folder.h"
#include "tb/sweep/export.h"
#include "tb/sweep/interval_text.h"
#include "tb/sweep/store.h"
#include "tb/sweep/store_check.h"
#include "tb/sweep/stored_frames.h"
#include "tb/sweep/sweep_changes.h"
#include "tb/sweep/sweep_folder.h"
#include "tb/sweep/sweep_kinds.h"
#include "tb/sweep/worker.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

// What status.json says, if it is whole.
Json kept_status(const SweepFolder& folder) {
  const Json json = Json::parse(folder.status(), nullptr, false);
  return json.is_object() ? json : Json::object();
}

Json status_json(const std::string& path) {
  const BegunFolder folder(path);
  Json json = {{"schema", "racebeam-sweep-status"}, {"version", 1}};
  json.update(kept_status(folder));
  const auto user = folder.user();
  if (!user && json.value("state", "") == "running") json["state"] = "killed";
  json["in_use_by"] = user ? Json(*user) : Json();
  Store store(folder.store(), Access::Read);
  const std::int64_t model = shown_model(store);
  json["stored_frames"] = model ? store.frames.count(model) : 0;
  json["disputed_frames"] = model ? store.frames.disputed(model) : 0;
  Json older = Json::array();
  if (model)
    for (const OlderScene& scene : older_scenes(store, model))
      older.push_back({{"scene", scene.name}, {"frames", scene.frames}});
  json["older_results"] = older;
  Json failures = Json::array();
  std::map<std::int64_t, std::string> names;
  for (const StoredPoint& point : store.points()) names[point.id] = point.name;
  if (model)
    for (const Failure& failure : store.failures.all(model))
      failures.push_back({{"point", names[failure.key.point]}, {"reason", failure.reason}});
  json["failures"] = failures;
  Json runs = Json::array();
  for (const SweepRun& run : store.runs.all())
    runs.push_back({{"started", run.started},
                    {"ended", run.ended.empty() ? Json() : Json(run.ended)},
                    {"host", run.host},
                    {"cores", run.cores},
                    {"cpu_seconds", run.cpu_seconds},
                    {"command", run.command}});
  json["runs"] = runs;
  return json;
}

std::string words(const Json& json) {
  std::string text =
      fmt::format("{}: {}", json.value("name", "sweep"), json.value("state", "not begun"));
  if (json["in_use_by"].is_string()) text += " by " + json["in_use_by"].get<std::string>();
  text += fmt::format("\n{} of {} points failed; rung of {} frames; {} frames are stored\n",
                      json.value("failed", 0), json.value("points", 0), json.value("rung", 0),
                      grouped(json["stored_frames"].get<long long>()));
  if (json.value("state", "") == "running")
    text +=
        fmt::format("{} of at most {} frames by this run, {:.0f} a second\n",
                    grouped(json.value("frames", 0LL)), grouped(json.value("frames_at_most", 0LL)),
                    json.value("frames_a_second", 0.0));
  if (const auto disputed = json["disputed_frames"].get<long long>())
    text += fmt::format("{} frames have differed from themselves\n", grouped(disputed));
  for (const Json& scene : json["older_results"])
    text += scenes_text({{0, scene["scene"], scene["frames"]}});
  for (const Json& failure : json["failures"])
    text += fmt::format("failed: {}: {}\n", failure["point"].get<std::string>(),
                        failure["reason"].get<std::string>());
  return text;
}

}  // namespace

std::string status_text(const std::string& folder, bool json) {
  const Json status = status_json(folder);
  return json ? status.dump(2, ' ', false, Json::error_handler_t::replace) + "\n" : words(status);
}

bool is_running(const std::string& folder) { return BegunFolder(folder).user().has_value(); }

bool check_sweep(const std::string& path, int sample, int jobs, std::string& report) {
  ForkServer server(work_on);  // before the store is opened
  const BegunFolder folder(path);
  const StoreReport sound = check_store(folder.store());
  report.clear();
  for (const std::string& fault : sound.faults) report += fault + "\n";
  if (!sound.faults.empty()) {
    for (const auto& [table, rows] : sound.rows)
      report += fmt::format("{}: {} rows can be read\n", table, grouped(rows));
    return false;
  }
  Store store(folder.store(), Access::Read);
  const std::int64_t model = shown_model(store);
  const std::int64_t frames = model ? store.frames.count(model) : 0;
  report += fmt::format("sound: {} frames, each as its digest says\n", grouped(frames));
  return repeat_frames(store, model, sample, server, jobs, report);
}

void export_sweep(const std::string& path, ExportKind kind, const std::string& file) {
  const BegunFolder folder(path);
  Store store(folder.store(), Access::Read);
  const std::int64_t model = shown_model(store);
  if (!model) throw UsageError(path + " has no results yet; run the sweep first");
  OutputFile out(file);
  if (kind == ExportKind::Points) export_points(store, model, out);
  else if (kind == ExportKind::Frames) export_frames(store, model, out);
  else export_json(store, out);
  out.finish();
  out.commit();
}

}  // namespace racebeam
