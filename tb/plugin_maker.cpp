// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/plugin_maker.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

#include "sc/rtl_parameters.h"
#include "sc/unit_choices.h"
#include "tb/console.h"
#include "tb/errors.h"
#include "tb/scene/program_tables.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/project_folder.h"
#include "tb/verilate/rtl_plugin.h"
#include "tb/verilate/rtl_syntax.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

/// "file" that holds `text`, for $readmemh.
std::string table_file(const std::string& text) {
  const std::string file = cached(content_key({text}) + ".hex",
                                  [&](const std::string& fresh) { std::ofstream(fresh) << text; });
  return "\"" + file + "\"";
}

RtlSources own_sources(const std::string& unit) {
  return {unit, {rtl_folder() + "/" + unit + ".sv"}, {}, {}, {}, {}, RtlSources::Unit, false};
}

/// The parameters that are whole numbers.
std::map<std::string, int> numbers(const RtlSyntax& syntax) {
  std::map<std::string, int> all;
  for (const RtlSyntax::Parameter& parameter : syntax.parameters)
    if (!parameter.value.empty()) all[parameter.name] = std::atoi(parameter.value.c_str());
  return all;
}

bool has_parameter(const RtlSyntax& syntax, const std::string& name) {
  return std::any_of(syntax.parameters.begin(), syntax.parameters.end(),
                     [&](const RtlSyntax::Parameter& own) { return own.name == name; });
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

std::string PluginMaker::own(const std::string& unit) const {
  RtlSources sources = own_sources(unit);
  for (const Setting& setting : settings(unit))
    sources.parameters.push_back(setting.name + "=" + setting.value);
  // The check of the wiring looks at the units inside racebeam_top.
  sources.signals = traced_ || unit == WholeChip;
  return rtl_plugin(sources);
}

std::string PluginMaker::users(const std::string& unit, const std::string& file) const {
  std::error_code error;
  if (!fs::is_regular_file(file, error))
    throw UsageError("there is no file '" + file + "' for the unit " + unit);
  if (fs::path(file).extension() == ".so") return file;
  RtlSources sources{unit, {file}, {}, {}, {}, {}, RtlSources::Unit, traced_};
  const RtlSyntax syntax = read_rtl_syntax(sources);
  for (const rtl_parameter& parameter : other_parameters(numbers(syntax), knobs_))
    sources.parameters.push_back(parameter.name + "=" + std::to_string(parameter.value));
  for (const Setting& table : tables(unit))
    if (has_parameter(syntax, table.name))
      sources.parameters.push_back(table.name + "=" + table.value);
  for (const Setting& setting : settings(unit))
    if (!has_parameter(syntax, setting.name))
      tell(file + " has no parameter " + setting.name + "; " + setting.what + " does not reach it");
  return rtl_plugin(sources);
}

std::string make_chip_plugin(const std::string& top, const std::vector<std::string>& sources) {
  return rtl_plugin({top, sources, {}, {}, {}, {}, RtlSources::Chip, false});
}

}  // namespace racebeam
