// SweepState: how the points of a sweep stand: which have been stopped, and how each compares.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tb/sweep/exact_figures.h"
#include "tb/sweep/figures.h"
#include "tb/sweep/front.h"
#include "tb/sweep/measurer.h"
#include "tb/sweep/point_reading.h"
#include "tb/sweep/racing.h"
#include "tb/sweep/sweep_plan.h"

namespace racebeam {

class SweepState {
 public:
  /// All of it outlives this.
  SweepState(const SweepPlan& plan, const Store& store, const Measurer& measurer)
      : plan_(plan), store_(store), measurer_(measurer), stops_(plan.points.size()) {}

  /// The plan has got more points.
  void take_in_points() { stops_.resize(plan_.points.size()); }
  /// Figures of designs, by point: what nobody measures in frames.
  void set_exact(int point, const std::string& figure, double value) {
    exact_[{point, figure}] = value;
  }

  std::vector<ExactFigure> exact() const;

  /// Points that go on: not stopped, not failed.
  std::vector<int> running() const;
  /// Stops those that need no more than their first frames.
  void race(int frames);
  /// Why it was stopped; "": it was not.
  const std::string& stopped(int point) const { return stops_[std::size_t(point)].why; }
  std::vector<StoppedPoint> stops() const;
  /// Whether the intervals of `until` are wide still, of a point that goes on.
  bool wide(int frames) const;

  /// From the first frames of each scene, and guard frames.
  PointReading read(int point, const PointFigure& figure, int frames) const;
  /// The same of several figures, with their columns read once.
  std::vector<PointReading> read(int point, const std::vector<const PointFigure*>& figures,
                                 int frames) const;
  /// Of the goals, from the first frames of each scene alone: guard frames may come later.
  std::vector<Reading> read_goals(int point, int frames) const;
  /// All that have not failed, with the goals of the file.
  struct Verdicts {
    std::vector<int> points;
    std::vector<Candidate> candidates;
    std::vector<Verdict> verdicts;
  };
  Verdicts judge(int frames) const;

 private:
  struct Stopped {
    int frames = 0;  ///< 0: it was not
    int by = -1;
    std::string why{};
  };

  std::vector<int> measured() const;
  /// `racing`: figures of frames of those that go on only.
  std::vector<Candidate> candidates(const std::vector<int>& points, int frames, bool racing) const;

  const SweepPlan& plan_;
  const Store& store_;
  const Measurer& measurer_;
  std::vector<Stopped> stops_;
  std::map<std::pair<int, std::string>, double> exact_;
};

}  // namespace racebeam
