// PluginMaker: the RTL of units for one chip: a unit's own, or a user's, with the parameters that
// the chip wants.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "sc/swap/rtl_parameters.h"
#include "tb/twin/island_text.h"
#include "tb/verilate/gate_netlist.h"
#include "tb/verilate/rtl_sources.h"

namespace racebeam {

class PluginMaker {
 public:
  /// What a parameter of a unit shall be.
  struct Setting {
    std::string name, value;  ///< value: as on Verilator's command line
    std::string what;         ///< "the knob fifo_entries", "the scene's table of rooms"
  };
  /// `wanted`: of every unit that has such parameters. `of_unit`: what else a unit is told, by its
  /// name. `traced`: signals inside the RTL can be read.
  explicit PluginMaker(std::vector<rtl_parameter> wanted,
                       std::function<std::vector<Setting>(const std::string& unit)> of_unit = {},
                       bool traced = false)
      : wanted_(std::move(wanted)), of_unit_(std::move(of_unit)), traced_(traced) {}

  /// The plug-in of a unit's own RTL, verilated if need be. `open`: as if traced. Throws RtlError,
  /// MissingTool, Interrupted.
  std::string own(const std::string& unit, bool open = false) const;
  /// The same, with registers inside that can be written to. Throws as own() does.
  std::string with_doors(const std::string& unit, const std::vector<std::string>& registers) const;
  /// What that is made of. Throws as own() does.
  RtlSources own_rtl(const std::string& unit, bool open = false) const;
  /// A unit's own RTL as part of an island; `instance`: its name there.
  IslandUnit island_unit(const std::string& unit, const std::string& instance,
                         bool back_door) const;
  /// The plug-in of several of them. Throws as own().
  std::string island(const std::vector<IslandUnit>& units) const;
  /// The plug-in of a user's RTL: a .so as it is, files as read_source_list() takes them verilated
  /// if need be. Tells what does not reach it. Throws UsageError, and as own() does.
  std::string users(const std::string& unit, const std::string& text, bool open = false) const;
  /// What that is made of; `text` names no .so. Throws as users() does.
  RtlSources users_rtl(const std::string& unit, const std::string& text, bool open = false) const;
  /// The plug-in of gates of a unit's own RTL or of a user's, made and verilated if need be; it
  /// tells what does not reach a user's. Throws as own() does.
  std::string gates(const std::string& unit, const GateWord& word, bool open = false) const;
  /// The file of generic gates that ParallelGates reads. Throws as own() does.
  std::string gate_bits(const std::string& unit, const GateWord& word) const;
  /// The gates themselves. Throws as own() does.
  GateNetlist netlist(const std::string& unit, const GateWord& word) const;

 private:
  /// What becomes gates, with its parameters.
  RtlSources gate_sources(const std::string& unit, const GateWord& word) const;
  std::vector<Setting> settings_of_unit(const std::string& unit) const;
  /// Throws RtlError if of `unit` only the model has a wanted value, and its RTL no such parameter.
  void expect_rtl_of(const std::string& unit,
                     const std::map<std::string, std::int64_t>& known) const;
  /// Everything that the unit's own RTL is told.
  std::vector<Setting> settings(const std::string& unit) const;
  static void tell_missing(const std::string& text, const std::vector<Setting>& settings,
                           const std::map<std::string, std::int64_t>& known);

  std::vector<rtl_parameter> wanted_;
  std::function<std::vector<Setting>(const std::string& unit)> of_unit_;
  bool traced_;
};

/// The plug-in of a whole chip with registered inputs. Throws as PluginMaker::own().
std::string make_chip_plugin(const std::string& top, const std::vector<std::string>& sources);

}  // namespace racebeam
