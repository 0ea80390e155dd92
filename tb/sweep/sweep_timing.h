// The whole chips of a sweep's points in technologies: area, longest path, and who gets the
// figures.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tb/sweep/chip_mapping.h"
#include "tb/sweep/measurer.h"
#include "tb/sweep/sweep_state.h"

namespace racebeam {

class SweepTimings {
 public:
  /// Looks for tools if the sweep asks for them. What is missing has no figures, which it says
  /// once; throws MissingTool if a goal needs it. What has failed in another run fails again,
  /// unless `fresh`. All of it outlives this.
  SweepTimings(const SweepPlan& plan, Store& store, bool fresh);
  /// Some tool is missing, and no goal needs it.
  bool absent() const { return absent_; }

  /// Maps the chips of these points, and gives the points their figures. A point without them is
  /// refused if a goal needs them. Throws Interrupted.
  void measure(const std::vector<int>& points, SweepState& state, Measurer& measurer, int jobs);

  /// A line for each point that has been measured: where its longest paths are, and tiles; "" if
  /// none has.
  std::string text() const;

 private:
  using Key = std::pair<int, std::string>;  // point, technology

  bool needs(const std::string& technology) const;
  void give(int point, const MappedChip& chip, SweepState& state);
  void refuse(int point, const std::string& technology, const std::string& why,
              Measurer& measurer) const;

  const SweepPlan& plan_;
  Store& store_;
  const bool fresh_;
  std::optional<Silicon> silicon_{};
  std::vector<Technology> technologies_{};
  bool absent_ = false;
  std::map<Key, MappedChip> chips_{};
};

}  // namespace racebeam
