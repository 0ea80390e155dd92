// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/unit_areas.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tb/base/nearest.h"
#include "tb/twin/twins.h"

namespace racebeam {

std::vector<UnitArea> areas_of(const engine& of, const std::vector<std::string>& units) {
  std::vector<std::string> known = of.unit_names(false);
  if (*of.top) known.emplace_back(of.top);
  for (const std::string& unit : units)
    if (std::find(known.begin(), known.end(), unit) == known.end())
      throw unknown_name("unit", unit, known);
  const PluginMaker maker = twins_of(of).plugins(of.standard(nullptr), nullptr, false);
  std::vector<UnitArea> areas;
  for (const std::string& unit : units.empty() ? known : units) {
    const GateNetlist netlist = maker.netlist(unit, {Osu018Gates, ""});
    areas.push_back({unit, netlist, gate_timing(of, unit, netlist)});
  }
  return areas;
}

std::string area_table(const std::vector<UnitArea>& areas) {
  std::string text = fmt::format("{:<18} {:>10} {:>6} {:>9} {:>9}  {}\n", "unit", "flip-flops",
                                 "cells", "um2", "slack ns", "longest path");
  for (const UnitArea& one : areas) {
    text += fmt::format("{:<18} {:>10} {:>6} {:>9.0f} {:>9.2f}  {} to {}", one.unit,
                        one.netlist.flip_flops, one.netlist.cells, one.netlist.area,
                        one.timing.slack(), one.timing.from, one.timing.to);
    for (const std::string& module : one.timing.excepted)
      text += fmt::format(", with the exceptions in {}.sdc", module);
    text += '\n';
  }
  return text;
}

std::string area_json(const engine& of, const std::vector<UnitArea>& areas) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const UnitArea& one : areas)
    rows.push_back({{"name", one.unit},
                    {"flip_flops", one.netlist.flip_flops},
                    {"cells", one.netlist.cells},
                    {"area", one.netlist.area},
                    {"longest_path", one.timing.ns},
                    {"slack", one.timing.slack()},
                    {"from", one.timing.from},
                    {"to", one.timing.to},
                    {"excepted", one.timing.excepted}});
  return nlohmann::ordered_json{
             {"schema", "racebeam-areas"}, {"version", 1}, {"engine", of.name}, {"units", rows}}
             .dump(2) +
         "\n";
}

}  // namespace racebeam
