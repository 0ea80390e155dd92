// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/plugin_maker.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "sc/base/unit_choices.h"
#include "sc/beam/units.h"
#include "sc/swap/rtl_library.h"
#include "sc/swap/rtl_parameters.h"
#include "tb/base/console.h"
#include "tb/scene/program_tables.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/project_folder.h"
#include "tb/verilate/rtl_plugin.h"
#include "tb/verilate/rtl_syntax.h"
#include "tb/verilate/source_list.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

/// "file" that holds `text`, for $readmemh.
std::string table_file(const std::string& text) {
  const std::string file = cached(content_key({text}) + ".hex", [&](const std::string& fresh) {
    std::ofstream out(fresh);
    out << text;
    out.close();
    if (!out) throw RtlError("cannot write " + fresh + "; is the disk full?");
  });
  return "\"" + file + "\"";
}

RtlSources own_sources(const std::string& unit) {
  return {unit, {rtl_file(unit)}, {}, {}, {}, {}, RtlSources::Unit, false};
}

/// The parameters by name; those that are texts as 0.
std::map<std::string, int> numbers(const RtlSyntax& syntax) {
  std::map<std::string, int> all;
  for (const RtlSyntax::Parameter& parameter : syntax.parameters)
    all[parameter.name] = std::atoi(parameter.value.c_str());
  return all;
}

}  // namespace

std::vector<PluginMaker::Setting> PluginMaker::tables(const std::string& unit) const {
  if (!program_) return {};
  const std::string what = "the scene's table of ";
  if (unit == "timeline")
    return {{"Shots", std::to_string(program_->shots.size()), what + "shots"},
            {"ShotFile", table_file(shot_table(*program_)), what + "shots"}};
  if (unit == "scene_rom")
    return {{"Rooms", std::to_string(program_->rooms.size()), what + "rooms"},
            {"RoomFile", table_file(room_table(*program_)), what + "rooms"}};
  return {};
}

std::vector<PluginMaker::Setting> PluginMaker::settings(const std::string& unit) const {
  std::vector<Setting> all = tables(unit);
  for (const rtl_parameter& parameter :
       other_parameters(numbers(read_rtl_syntax(own_sources(unit))), knobs_))
    all.push_back({parameter.name, std::to_string(parameter.value), "the knob " + parameter.knob});
  return all;
}

void PluginMaker::tell_missing(const std::string& text, const std::vector<Setting>& settings,
                               const std::map<std::string, int>& known) {
  std::set<std::string> told;
  for (const Setting& setting : settings)
    if (known.count(setting.name) == 0 && told.insert(setting.what).second)
      tell(text + " has no parameter " + setting.name + "; " + setting.what + " does not reach it");
}

std::string PluginMaker::own(const std::string& unit) const {
  RtlSources sources = own_sources(unit);
  for (const Setting& setting : settings(unit))
    sources.parameters.push_back(setting.name + "=" + setting.value);
  // The check of the wiring looks at the units inside racebeam_top.
  sources.signals = traced_ || unit == WholeChip;
  return rtl_plugin(sources);
}

std::string PluginMaker::users(const std::string& unit, const std::string& text) const {
  if (fs::path(text).extension() == ".so") {
    if (fs::exists(text))
      tell_missing(text, settings(unit), built_parameters(rtl_library(text).model()));
    return text;
  }
  RtlSources sources = read_source_list(unit, text);
  sources.signals = traced_ || unit == WholeChip;
  const RtlSyntax syntax = read_rtl_syntax(sources);
  for (const RtlSyntax::Place& call : syntax.calls)
    tell(call.file + ":" + std::to_string(call.line) + ": " + call.name +
         " reaches beyond the simulation, with your rights");
  const std::map<std::string, int> known = numbers(syntax);
  for (const rtl_parameter& parameter : other_parameters(known, knobs_))
    sources.parameters.push_back(parameter.name + "=" + std::to_string(parameter.value));
  for (const Setting& table : tables(unit))
    if (known.count(table.name) != 0) sources.parameters.push_back(table.name + "=" + table.value);
  tell_missing(text, settings(unit), known);
  return rtl_plugin(sources);
}

std::string make_chip_plugin(const std::string& top, const std::vector<std::string>& sources) {
  return rtl_plugin({top, sources, {}, {}, {}, {}, RtlSources::Chip, false});
}

}  // namespace racebeam
