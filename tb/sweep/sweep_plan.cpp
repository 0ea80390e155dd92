// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "tb/base/console.h"
#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/show/open_show.h"
#include "tb/sweep/figures.h"
#include "tb/sweep/frame_order.h"
#include "tb/sweep/interval_text.h"
#include "tb/sweep/row_digest.h"
#include "tb/sweep/sweep_kinds.h"
#include "tb/sweep/sweep_points.h"
#include "tb/sweep/sweep_reader.h"

namespace racebeam {

namespace {

SweepNames sweep_names() {
  SweepNames names;
  for (const PointFigure& figure : figure_table())
    names.figures.push_back(
        {figure.name, figure.unit, figure.sampled(), figure.measure(), engines_with(figure)});
  names.scenes = scene_names();
  names.is_scene = [](const std::string& scene) {
    return scene == "demo" || std::filesystem::exists(scene_path(scene));
  };
  names.engine_of = [](const std::string& scene) { return &open_show(scene).engine(); };
  names.measures = [](const engine& built) { return sweep_kind(built).measures; };
  return names;
}

SweepScene open_scene(const std::string& name, const SweepFile& file, int& left_out) {
  SweepScene scene{name, open_show(name), {}};
  std::vector<int> allowed;
  for (int frame = 0; frame < scene.show.frames(); ++frame)
    if (!file.frames.skips(scene.show.part(frame))) allowed.push_back(frame);
  left_out += scene.show.frames() - static_cast<int>(allowed.size());
  if (allowed.empty())
    throw UsageError("frames.skip leaves no frame of " + name + "; give fewer patterns");
  scene.order = frame_order(allowed, file.search.seed);
  return scene;
}

// Results of a point depend on its knobs and on what they are compared with.
std::string setting(const knob_values& k, const SweepFile& file, const knob_values& base) {
  std::string text = point_text(k) + "reference=" +
                     reference_words()[static_cast<std::size_t>(file.measure.reference)] + "\n";
  if (file.measure.reference == SweepReference::Base)
    text += "reference_base=" + text_hash(point_text(base)) + "\n";
  return text;
}

std::vector<knob_values> standards_of(const SweepPlan& plan) {
  std::vector<knob_values> standards;
  for (const SweepScene& scene : plan.scenes) standards.push_back(scene.show.standard_knobs());
  return standards;
}

PlannedPoint planned(const SweepPlan& plan, const SweepPoint& point, const SweepPoint& base) {
  PlannedPoint planned{point, {}, {}};
  for (const SweepScene& scene : plan.scenes) {
    const knob_values standard = scene.show.standard_knobs();
    const knob_values k = knobs_on(point, standard);
    if (const std::string why = scene.show.objection(k); !why.empty() && planned.objection.empty())
      planned.objection = fmt::format("{} on {}: {}", point.name, scene.name, why);
    planned.k.push_back(k);
    planned.settings.push_back(setting(k, plan.file, knobs_on(base, standard)));
  }
  return planned;
}

SweepPlan plan(SweepResult read) {
  SweepPlan plan{std::move(read.file), std::move(read.text), {}, {}};
  for (const std::string& name : plan.file.scenes)
    plan.scenes.push_back(open_scene(name, plan.file, plan.left_out));
  const SweepPoints points = sweep_points(plan.file, standards_of(plan));
  std::size_t objections = 0;
  for (const SweepPoint& point : points.points) {
    plan.points.push_back(planned(plan, point, points.points.front()));
    if (plan.points.back().objection.empty()) continue;
    tell(plan.points.back().objection);
    ++objections;
  }
  if (objections > 0)
    throw UsageError(counted(objections, "point") +
                     " cannot be run on a scene; leave them out with knobs.where");
  for (const auto& [name, same] : points.same) tell(name + " is " + same + " by another name");
  if (plan.file.search.adapts())
    for (const auto& [indices, point] : points.asked) plan.first.push_back(indices);
  return plan;
}

}  // namespace

int SweepPlan::sample(std::size_t scene) const {
  const int all = static_cast<int>(scenes[scene].order.size());
  return file.frames.sample == 0 ? all : std::min(file.frames.sample, all);
}

int SweepPlan::population() const {
  int frames = 0;
  for (const SweepScene& scene : scenes) frames += static_cast<int>(scene.order.size());
  return frames;
}

int SweepPlan::points_at_most() const {
  const SweepSearch& search = file.search;
  if (!search.adapts()) return static_cast<int>(points.size());
  return 1 + static_cast<int>(file.points.size()) + search.population * (search.generations + 1);
}

std::vector<int> SweepPlan::add(const std::vector<ValueIndices>& generation) {
  added.insert(added.end(), generation.begin(), generation.end());
  const SweepPoints all = sweep_points(file, standards_of(*this), added);
  for (std::size_t point = points.size(); point < all.points.size(); ++point)
    points.push_back(planned(*this, all.points[point], all.points.front()));
  std::vector<int> asked;
  for (std::size_t i = all.asked.size() - generation.size(); i < all.asked.size(); ++i)
    asked.push_back(all.asked[i].second);
  return asked;
}

std::string SweepPlan::key() const {
  std::string all = text;
  for (const PlannedPoint& point : points) {
    all += "\n" + point.point.name;
    for (const std::string& one : point.settings) all += "\n" + one;
  }
  for (const SweepScene& scene : scenes) all += "\n" + scene.show.hash();
  return text_hash(all);
}

SweepPlan plan_sweep(const std::string& path, const std::vector<std::string>& narrowed) {
  return plan(load_sweep(path, sweep_names(), narrowed));
}

SweepPlan plan_sweep_text(const std::string& text, const std::string& name) {
  SweepResult result = read_sweep(text, name, sweep_names());
  if (!result.faults.none()) {
    std::fputs(result.faults.text(name).c_str(), stderr);
    throw UsageError(counted(result.faults.count(), "fault") + " in " + name);
  }
  result.text = text;
  return plan(std::move(result));
}

}  // namespace racebeam
