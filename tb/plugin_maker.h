// PluginMaker: verilates, for one run, the RTL that cannot be built beforehand: a user's own, and
// that of the units that read a scene's tables.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sc/knobs.h"
#include "sc/scene_program.h"

namespace racebeam {

/// Plug-ins that are not the user's lie in a scratch folder that goes with the program.
class PluginMaker {
 public:
  /// For chips with the knobs `k` that show `program`; nullptr: the built-in demo. `traced`:
  /// signals inside the RTL can be read.
  PluginMaker(const knobs& k, const scene_program* program, bool traced = false)
      : knobs_(k), program_(program), traced_(traced) {}

  /// The plug-in of a unit's own RTL with the program's table; empty if the unit reads none and
  /// is not traced, since the chip finds that RTL itself. Throws RtlError, MissingTool.
  std::string own(const std::string& unit) const;
  /// The plug-in of a user's RTL: a .so as it is, a .sv or .v verilated. Throws UsageError,
  /// RtlError, MissingTool.
  std::string users(const std::string& unit, const std::string& file) const;

 private:
  std::vector<std::string> table_parameters(const std::string& unit) const;

  knobs knobs_;
  const scene_program* program_;
  bool traced_;
};

/// The plug-in of a whole chip with registered inputs, in the scratch folder. Throws RtlError,
/// MissingTool.
std::string make_chip_plugin(const std::string& top, const std::vector<std::string>& sources);

}  // namespace racebeam
