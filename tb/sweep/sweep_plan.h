// SweepPlan: a sweep file with all that it names opened: what is to be measured, before anything
// is.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/show/show.h"
#include "tb/sweep/sweep_file.h"
#include "tb/sweep/value_indices.h"

namespace racebeam {

struct SweepScene {
  std::string name;  ///< as in the file
  Show show;
  std::vector<int> order;  ///< the frames that may be taken, in the order in which they are
};

struct PlannedPoint {
  SweepPoint point;
  std::vector<knob_values> k;         ///< by scene
  std::vector<std::string> settings;  ///< by scene: what tells its results from others
  std::string objection{};            ///< why it cannot be run; only of points that were added
};

struct SweepPlan {
  SweepFile file;
  std::string text;  ///< of the file
  std::vector<SweepScene> scenes;
  std::vector<PlannedPoint> points;   ///< the base first
  int left_out = 0;                   ///< frames of parts that are skipped, of all scenes
  std::vector<ValueIndices> first{};  ///< of nsga2: its first generation
  std::vector<ValueIndices> added{};  ///< what it has asked for since

  /// Frames of a scene that a point takes.
  int sample(std::size_t scene) const;
  int population() const;  ///< frames that may be taken, of all scenes
  /// With all that nsga2 may ask for.
  int points_at_most() const;
  /// Plans what nsga2 asks for, as far as it is new; which points these are; -1: `where` refuses
  /// it.
  std::vector<int> add(const std::vector<ValueIndices>& generation);
  /// What makes it another run: the file, what was narrowed, and the scenes.
  std::string key() const;
};

/// Reads a sweep file and opens its scenes. Throws UsageError after all faults are on stderr.
SweepPlan plan_sweep(const std::string& path, const std::vector<std::string>& narrowed);
/// The same of a text; `name` is what faults and the sweep are called by.
SweepPlan plan_sweep_text(const std::string& text, const std::string& name);

}  // namespace racebeam
