// Reads a sweep file: all that is good in it, and all its faults at once.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tb/scene/faults.h"
#include "tb/sweep/goal_reader.h"
#include "tb/sweep/sweep_file.h"

namespace racebeam {

/// What [measure] may ask of an engine.
struct EngineMeasures {
  bool causes;               ///< errors by cause
  SweepReference reference;  ///< the last that its pictures are compared with
};

/// What a sweep file may name beside knobs.
struct SweepNames {
  std::vector<SweepFigure> figures;
  std::vector<std::string> scenes;                   ///< the project's, for advice
  std::function<bool(const std::string&)> is_scene;  ///< whether there is one of this name or path
  /// Who shows it; empty: the first engine shows all.
  std::function<const engine*(const std::string&)> engine_of{};
  std::function<EngineMeasures(const engine&)> measures{};  ///< empty: all of it
};

struct SweepResult {
  SweepFile file{};  ///< usable only without faults
  Faults faults{};
  std::string text{};  ///< of a file that could be read
};

/// Reads and checks a sweep from its text. `name` is its name if the text gives none. `narrowed`:
/// as of narrow(), before the points are counted; throws UsageError if one of them is bad.
SweepResult read_sweep(std::string_view text, const std::string& name, const SweepNames& names,
                       const std::vector<std::string>& narrowed = {});

/// The same from a file; a file that cannot be read is a fault too.
SweepResult read_sweep_file(const std::string& path, const SweepNames& names,
                            const std::vector<std::string>& narrowed = {});

/// The same for a command: writes faults and warnings to stderr; throws UsageError after faults.
SweepResult load_sweep(const std::string& path, const SweepNames& names,
                       const std::vector<std::string>& narrowed = {});

}  // namespace racebeam
