// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_state.h"

#include <algorithm>
#include <cmath>

namespace racebeam {

namespace {

// Without guard frames, which are there only in a sweep that has ended.
Stratum of_first(const Stratum& all, const std::vector<int>& order, int frames) {
  const auto taken = std::min(order.size(), static_cast<std::size_t>(frames));
  std::vector<int> first(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(taken));
  std::sort(first.begin(), first.end());
  Stratum of{{}, {}, all.population};
  for (std::size_t i = 0; i < all.frames.size(); ++i)
    if (std::binary_search(first.begin(), first.end(), all.frames[i])) {
      of.frames.push_back(all.frames[i]);
      of.values.push_back(all.values[i]);
    }
  return of;
}

}  // namespace

std::vector<int> SweepState::running() const {
  std::vector<int> points;
  for (int point = 0; point < static_cast<int>(plan_.points.size()); ++point)
    if (stopped(point).empty() && measurer_.failure(point).empty()) points.push_back(point);
  return points;
}

PointReading SweepState::read(int point, const PointFigure& figure, int frames) const {
  return read(point, std::vector<const PointFigure*>{&figure}, frames).front();
}

std::vector<PointReading> SweepState::read(int point,
                                           const std::vector<const PointFigure*>& figures,
                                           int frames) const {
  std::vector<SceneFrames> scenes;
  for (int scene = 0; scene < static_cast<int>(plan_.scenes.size()); ++scene)
    scenes.push_back(
        {measurer_.key(point, scene), &plan_.scenes[static_cast<std::size_t>(scene)].order});
  std::vector<PointReading> all = read_figures(store_.frames, scenes, figures, frames);
  for (std::size_t i = 0; i < figures.size(); ++i)
    if (const auto at = exact_.find({point, figures[i]->name});
        figures[i]->kind == PointFigure::Exact && at != exact_.end()) {
      all[i].there = true;
      all[i].reading.exact = at->second;
    }
  return all;
}

std::vector<Reading> SweepState::read_goals(int point, int frames) const {
  std::vector<Reading> goals;
  for (const Goal& goal : plan_.file.goals) {
    Reading reading = read(point, *figure_named(goal.figure, *plan_.file.built), frames).reading;
    for (std::size_t scene = 0; scene < reading.frames.size(); ++scene)
      reading.frames[scene] = of_first(reading.frames[scene], plan_.scenes[scene].order, frames);
    goals.push_back(std::move(reading));
  }
  return goals;
}

std::vector<int> SweepState::measured() const {
  std::vector<int> points;
  for (int point = 0; point < static_cast<int>(plan_.points.size()); ++point)
    if (measurer_.failure(point).empty()) points.push_back(point);
  return points;
}

std::vector<Candidate> SweepState::candidates(const std::vector<int>& points, int frames,
                                              bool racing) const {
  std::vector<Candidate> all;
  for (const int point : points) {
    Candidate candidate;
    candidate.name = plan_.points[static_cast<std::size_t>(point)].point.name;
    candidate.base = point == 0;
    candidate.stopped = racing && !stopped(point).empty();
    for (const Goal& goal : plan_.file.goals) {
      const PointFigure& figure = *figure_named(goal.figure, *plan_.file.built);
      candidate.readings.push_back(candidate.stopped && figure.kind != PointFigure::Exact
                                       ? Reading{reading_kind(figure), 0, {}}
                                       : read(point, figure, frames).reading);
    }
    all.push_back(std::move(candidate));
  }
  return all;
}

void SweepState::race(int frames) {
  const std::vector<int> points = measured();
  for (const Stop& stop :
       racebeam::stops(candidates(points, frames, true), plan_.file.goals, frames, Confidence)) {
    Stopped& stopped = stops_[static_cast<std::size_t>(points[stop.point])];
    stopped = {frames, stop.by < 0 ? -1 : points[static_cast<std::size_t>(stop.by)], stop.why};
  }
}

std::vector<ExactFigure> SweepState::exact() const {
  std::vector<ExactFigure> all;
  for (const auto& [of, value] : exact_)
    all.push_back({measurer_.key(of.first, 0).point, of.second, value});
  return all;
}

std::vector<StoppedPoint> SweepState::stops() const {
  std::vector<StoppedPoint> all;
  for (int point = 0; point < static_cast<int>(stops_.size()); ++point) {
    const Stopped& one = stops_[static_cast<std::size_t>(point)];
    if (!one.why.empty())
      all.push_back({measurer_.key(point, 0).point, one.frames,
                     one.by < 0 ? 0 : measurer_.key(one.by, 0).point, one.why});
  }
  return all;
}

bool SweepState::wide(int frames) const {
  for (const auto& [name, percent] : plan_.file.frames.until)
    for (const int point : running()) {
      const PointReading read = this->read(point, *figure_named(name, *plan_.file.built), frames);
      const Estimate mean = mean_of(read.reading.frames);
      if (!mean.all() && mean.half_width > percent / 100 * std::abs(mean.value)) return true;
    }
  return false;
}

SweepState::Verdicts SweepState::judge(int frames) const {
  Verdicts all;
  all.points = measured();
  all.candidates = candidates(all.points, frames, false);
  all.verdicts = racebeam::judge(all.candidates, plan_.file.goals, Confidence);
  return all;
}

}  // namespace racebeam
