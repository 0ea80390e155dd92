// PluginMaker: the RTL of units for one chip: a unit's own, or a user's, with the chip's knobs and
// its scene's tables as parameters.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sc/base/knobs.h"
#include "sc/beam/scene_program.h"
#include "tb/verilate/rtl_sources.h"

namespace racebeam {

class PluginMaker {
 public:
  /// For chips with the knobs `k` that show `program`; nullptr: the built-in demo. `traced`:
  /// signals inside the RTL can be read.
  PluginMaker(const knobs& k, const scene_program* program, bool traced = false)
      : knobs_(k), program_(program), traced_(traced) {}

  /// The plug-in of a unit's own RTL, verilated if need be. Throws RtlError, MissingTool,
  /// Interrupted.
  std::string own(const std::string& unit) const;
  /// The plug-in of a user's RTL: a .so as it is, files as read_source_list() takes them verilated
  /// if need be. Tells which knobs do not reach it. Throws UsageError, and as own() does.
  std::string users(const std::string& unit, const std::string& text) const;

 private:
  /// What a parameter of the unit shall be.
  struct Setting {
    std::string name, value;  ///< value: as on Verilator's command line
    std::string what;         ///< "the knob fifo_entries", "the scene's table of rooms"
  };
  std::vector<Setting> tables(const std::string& unit) const;
  /// Everything that the unit's own RTL is told.
  std::vector<Setting> settings(const std::string& unit) const;
  static void tell_missing(const std::string& text, const std::vector<Setting>& settings,
                           const std::map<std::string, int>& known);

  knobs knobs_;
  const scene_program* program_;
  bool traced_;
};

/// The plug-in of a whole chip with registered inputs. Throws as PluginMaker::own().
std::string make_chip_plugin(const std::string& top, const std::vector<std::string>& sources);

}  // namespace racebeam
