// Two sweeps held against each other, or two models of one sweep: what has changed, and how much.
//
// Points are paired by their knobs, whatever they are called; one that only one side knows counts
// as if it were not there while it has its default. They are compared on the frames of the same
// scenes that both have. The simulator is exact: a point has changed if any number of a frame or
// any pixel has; by how much on average, over the frames that are not there too, has an interval.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/base/engine.h"
#include "tb/sweep/figures.h"
#include "tb/sweep/interval.h"
#include "tb/sweep/store.h"

namespace racebeam {

struct AgainstSide {
  std::string folder;
  StoredModel model;
  std::vector<std::string> alone;  ///< points that the other does not have, by name
};

/// A figure that is not the same on both sides.
struct ChangedFigure {
  const PointFigure* figure;
  double before = 0, now = 0;
  /// Of a sampled figure with the interval for all points that changed. Of others exact.
  Estimate change{};

  bool surely() const { return change.differs_from(0); }
};

struct AgainstPoint {
  std::string name, name_before;
  std::string setting;                      ///< knobs that are not as by default
  int frames = 0;                           ///< of the sample that both have, of all scenes
  int frames_now = 0, frames_before = 0;    ///< that each has
  std::string failure_now, failure_before;  ///< why it could not be measured
  bool changed = false;                     ///< in those frames, guard frames too, or its design
  std::vector<ChangedFigure> figures{};     ///< as the table of figures has them
};

struct SweepAgainst {
  AgainstSide now, before;
  const engine* built = nullptr;
  std::vector<AgainstPoint> points;  ///< that both have, as they come now
  std::vector<std::string> notes;    ///< what could not be compared, a line for each

  int changed() const;
  /// Points that failed on one side only.
  int failed() const;
  bool same() const { return changed() == 0 && failed() == 0; }
};

/// `folder` as it is now against `before`. If they are the same one, its model against the one that
/// it had before. Throws UsageError if there is nothing to compare, and says why.
SweepAgainst sweep_against(const std::string& folder, const std::string& before);

/// A table of what changed, and counts.
std::string against_text(const SweepAgainst& against);
std::string against_json(const SweepAgainst& against);

}  // namespace racebeam
