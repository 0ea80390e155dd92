// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/reported_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/report/report_silicon.h"
#include "tb/sweep/figure_file.h"
#include "tb/sweep/interval_text.h"
#include "tb/sweep/stored_setting.h"
#include "tb/sweep/sweep_changes.h"
#include "tb/sweep/verdict_words.h"

namespace racebeam {

namespace {

using Status = nlohmann::json;

std::string file_name(const std::string& folder) { return folder + "/sweep.toml"; }

SweepPlan plan_of(const BegunFolder& folder) {
  const std::string text = folder.sweep();
  if (text.empty())
    throw UsageError(folder.path() + " has no sweep.toml yet: racebeam sweep run FILE.toml -o " +
                     folder.path() + " goes on");
  return plan_sweep_text(text, file_name(folder.path()));
}

/// A point's ids, one for all scenes or one each.
struct Group {
  std::string name;
  std::vector<StoredPoint> points;
  std::size_t place;  // in the plan; what a search brings later comes behind
};

std::vector<Group> groups_of(const std::vector<StoredPoint>& stored, const SweepPlan& plan) {
  std::map<std::string, std::size_t> places;
  for (std::size_t at = 0; at < plan.points.size(); ++at)
    for (const std::string& setting : plan.points[at].settings) places.emplace(setting, at);
  std::vector<Group> groups;
  for (const StoredPoint& point : stored) {
    if (point.name.empty()) continue;  // the sweep has no such point any more
    const auto planned = places.find(point.setting);
    const std::size_t place = planned == places.end() ? plan.points.size() : planned->second;
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const Group& one) { return one.name == point.name; });
    if (group == groups.end()) group = groups.insert(groups.end(), Group{point.name, {}, place});
    group->points.push_back(point);
    group->place = std::min(group->place, place);
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Group& a, const Group& b) { return a.place < b.place; });
  return groups;
}

ReportedFigure figure_of(const PointFigure& figure, const PointReading& of,
                         const PointReading& base) {
  if (figure.kind == PointFigure::Exact)
    return {true, {of.reading.exact, 0, 0, 0}, Estimate{of.reading.exact - base.reading.exact, 0}};
  if (!figure.sampled()) {
    const Worst worst = worst_of(of.reading.frames);
    return {true, {worst.value, 0, worst.frames, worst.population}, {}};
  }
  return {true, mean_of(of.reading.frames), difference_of(of.reading.frames, base.reading.frames)};
}

std::size_t place_of(const PointFigure* figure, const std::vector<const PointFigure*>& in) {
  return static_cast<std::size_t>(std::find(in.begin(), in.end(), figure) - in.begin());
}

}  // namespace

int ReportedSweep::failed() const {
  return static_cast<int>(std::count_if(points.begin(), points.end(),
                                        [](const auto& point) { return point.failed(); }));
}

int ReportedSweep::measured() const {
  return static_cast<int>(std::count_if(points.begin(), points.end(),
                                        [](const auto& point) { return point.measured(); }));
}

const ReportedFigure* ReportedSweep::figure(const ReportedPoint& point,
                                            const std::string& wanted) const {
  for (std::size_t i = 0; i < point.figures.size(); ++i)
    if (figures[i]->name == wanted && point.figures[i].there) return &point.figures[i];
  return nullptr;
}

SweepReader::SweepReader(const std::string& path)
    : folder_(path), store_(folder_.store(), Access::Read), sweep_{"", "", plan_of(folder_)} {
  store_.database().run("BEGIN");  // all of it as it is now, whoever writes meanwhile
  read_state();
  if (sweep_.model.id == 0) return;
  read_points();
  read_figures_of_points();
  judge_points();
}

void SweepReader::read_state() {
  const Status status = Status::parse(folder_.status(), nullptr, false);
  const auto text = [&](const char* key, const std::string& otherwise) {
    return status.is_object() && status.contains(key) && status[key].is_string()
               ? status[key].get<std::string>()
               : otherwise;
  };
  sweep_.name = text("name", sweep_.plan.file.name);
  sweep_.state = text("state", "");
  const int rung = status.is_object() ? status.value("rung", 0) : 0;
  frames_ = rung > 0 ? rung : std::numeric_limits<int>::max();
  const auto user = folder_.user();
  if (sweep_.state == "running" && !user) sweep_.state = "killed";
  sweep_.runs = store_.runs.all();
  const std::int64_t model = shown_model(store_);
  for (const StoredModel& one : store_.models())
    if (one.id == model) sweep_.model = one;
  if (user) sweep_.remarks.push_back("The sweep is being measured by " + *user + ".");
  else if (sweep_.state != "done")
    sweep_.remarks.push_back("The sweep has not ended: racebeam sweep run goes on with it.");
  if (model == 0) return;
  if (const auto disputed = store_.frames.disputed(model))
    sweep_.remarks.push_back(
        fmt::format("{} have differed from themselves when they were measured again.",
                    counted(disputed, "frame")));
  for (const OlderScene& scene : older_scenes(store_, model))
    sweep_.remarks.push_back(
        fmt::format("The scene {} has changed: {} older results are of the other one.", scene.name,
                    grouped(scene.frames)));
}

void SweepReader::read_points() {
  const SweepPlan& plan = sweep_.plan;
  const std::int64_t model = sweep_.model.id;
  std::vector<std::unordered_map<std::int64_t, std::vector<KeptFrame>>> there;
  for (const SweepScene& scene : plan.scenes) {
    scenes_.push_back(0);
    for (const StoredScene& stored : store_.scenes())
      if (stored.hash == scene.show.hash()) scenes_.back() = stored.id;
    there.push_back(store_.frames.there(model, scenes_.back()));
  }
  for (const Group& group : groups_of(store_.points(), plan)) {
    ReportedPoint& point = sweep_.points.emplace_back();
    point.name = group.name;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
      const StoredPoint* of = &group.points.front();
      for (const StoredPoint& one : group.points)
        if (group.place < plan.points.size()
                ? one.setting == plan.points[group.place].settings[scene]
                : there[scene].count(one.id) > 0)
          of = &one;
      point.keys.push_back({model, scenes_[scene], of->id});
      point.k.push_back(plan.scenes[scene].show.standard_knobs());
      SweepReference reference{};
      if (!read_setting(of->setting, point.k.back(), reference))
        throw UsageError(fmt::format("{}: {} has values of knobs that this program does not know",
                                     folder_.store(), group.name));
    }
  }
  const auto has = [&](const ReportedPoint& point, std::int64_t id) {
    return std::any_of(point.keys.begin(), point.keys.end(),
                       [id](const FrameKey& key) { return key.point == id; });
  };
  const std::vector<Failure> failures = store_.failures.all(model);
  const std::vector<StoppedPoint> stopped = store_.stopped.all(model);
  for (ReportedPoint& point : sweep_.points) {
    for (const StoppedPoint& one : stopped)
      if (has(point, one.point)) point.reason = one.why;
    for (const Failure& one : failures)
      if (has(point, one.key.point)) {
        point.standing = "failed";
        point.reason = one.reason;
      }
  }
}

void SweepReader::read_figures_of_points() {
  const std::vector<std::string>& columns = store_.frames.columns(sweep_.model.id);
  std::vector<const PointFigure*> all;
  for (const PointFigure* figure : sweep_figures(sweep_.plan.file))
    if (figure->kind == PointFigure::Exact || figure->of_cause || !figure->missing(columns))
      all.push_back(figure);
  exact_ = exact_figures(sweep_, folder_, store_);
  std::vector<PointReading> base;
  std::vector<bool> used(all.size());
  const std::vector<const PointFigure*> led = shown_figures(sweep_.plan.file);
  for (ReportedPoint& point : sweep_.points) {
    std::vector<SceneFrames> scenes;
    for (std::size_t scene = 0; scene < point.keys.size(); ++scene)
      scenes.push_back({point.keys[scene], &sweep_.plan.scenes[scene].order});
    std::vector<PointReading> readings = read_figures(store_.frames, scenes, all, frames_);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (const auto of = exact_.find(point.name);
          all[i]->kind == PointFigure::Exact && of != exact_.end())
        if (const auto at = of->second.find(all[i]->name); at != of->second.end())
          readings[i] = {true, {Reading::Exact, at->second, {}}};
    if (base.empty()) base = readings;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool there = readings[i].there && base[i].there && !point.failed();
      used[i] = used[i] || there;
      point.figures.push_back(there ? figure_of(*all[i], readings[i], base[i]) : ReportedFigure{});
      if (all[i]->sampled() && !all[i]->of_cause && there)
        point.frames = std::max(point.frames, point.figures.back().value.frames);
    }
    for (const PointFigure* figure : led)
      point.led.push_back(place_of(figure, all) < all.size() ? readings[place_of(figure, all)]
                                                             : PointReading{});
  }
  sweep_.led = led;
  for (std::size_t i = all.size(); i-- > 0;)
    if (!used[i])
      for (ReportedPoint& point : sweep_.points)
        point.figures.erase(point.figures.begin() + static_cast<std::ptrdiff_t>(i));
  for (std::size_t i = 0; i < all.size(); ++i)
    if (used[i]) sweep_.figures.push_back(all[i]);
  for (std::size_t row = 0; row < sweep_.built().knobs.size(); ++row)
    for (const ReportedPoint& point : sweep_.points)
      if (point.k.front()[row] != sweep_.points.front().k.front()[row]) {
        sweep_.knobs.push_back(row);
        break;
      }
}

void SweepReader::judge_points() {
  const std::vector<Goal>& goals = sweep_.plan.file.goals;
  std::vector<ReportedPoint*> judged;
  for (ReportedPoint& point : sweep_.points) {
    if (point.failed()) continue;
    point.standing = point.measured() ? "measured" : "not measured";
    bool all = point.measured();
    Candidate candidate{point.name, {}, judged.empty()};
    for (std::size_t goal = 0; goal < goals.size() && all; ++goal) {
      const PointReading& reading =
          point.led[place_of(figure_named(goals[goal].figure, sweep_.built()), sweep_.led)];
      all = reading.there;
      candidate.readings.push_back(reading.reading);
    }
    if (!all) continue;
    judged.push_back(&point);
    sweep_.candidates.push_back(std::move(candidate));
  }
  sweep_.verdicts = judge(sweep_.candidates, goals, Confidence);
  if (goals.empty()) return;
  for (std::size_t i = 0; i < judged.size(); ++i) {
    const Verdict& verdict = sweep_.verdicts[i];
    judged[i]->standing = standing_word(verdict.standing);
    if (!judged[i]->reason.empty()) continue;
    if (verdict.standing == Verdict::Dominated)
      judged[i]->reason = "dominated by " + judged[std::size_t(verdict.by)]->name;
    if (verdict.standing == Verdict::Unwanted)
      judged[i]->reason = "beyond the limit of " + goals[std::size_t(verdict.by)].figure;
  }
}

}  // namespace racebeam
