// Figures in a sweep file: what is wanted of them, and how sure they shall be.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tb/scene/toml_tree.h"
#include "tb/sweep/sweep_file.h"

namespace racebeam {

/// A figure as far as a sweep file knows it.
struct SweepFigure {
  std::string name;
  std::string unit;          ///< "%", "clocks a line"
  bool sampled = true;       ///< estimated from frames, with an interval
  std::string measure = {};  ///< key of [measure] that brings it, "silicon", "causes", or empty
  std::vector<const engine*> engines = {};  ///< that have it; empty: all
  bool foreign = false;                     ///< the sweep's engine does not have it
};

/// [goals]: "min", "max", { most = "0.5 %" }, { least = 3 }. A goal that is not measured is a
/// fault: `measure` has been read.
std::vector<Goal> read_goals(const TomlNode& node, const std::vector<SweepFigure>& figures,
                             const SweepMeasure& measure, Faults& faults);

/// frames.until: figures and their widest intervals, "5 %" of the mean.
std::vector<std::pair<std::string, double>> read_until(const TomlNode& node,
                                                       const std::vector<SweepFigure>& figures,
                                                       Faults& faults);

}  // namespace racebeam
