// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/plugin_maker.h"

#include <cstdlib>
#include <filesystem>
#include <set>

#include "sc/swap/rtl_island.h"
#include "sc/swap/rtl_library.h"
#include "tb/base/console.h"
#include "tb/base/output_file.h"
#include "tb/base/project_folder.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/comb_paths.h"
#include "tb/verilate/rtl_plugin.h"
#include "tb/verilate/rtl_syntax.h"
#include "tb/verilate/source_list.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

RtlSources own_sources(const std::string& unit) {
  return {unit, {rtl_file(unit)}, {}, {}, {}, {}, RtlSources::Unit, false};
}

/// The parameters by name; those that are texts as 0.
std::map<std::string, std::int64_t> numbers(const RtlSyntax& syntax) {
  std::map<std::string, std::int64_t> all;
  for (const RtlSyntax::Parameter& parameter : syntax.parameters)
    all[parameter.name] = std::strtoll(parameter.value.c_str(), nullptr, 10);
  return all;
}

}  // namespace

std::vector<PluginMaker::Setting> PluginMaker::settings_of_unit(const std::string& unit) const {
  return of_unit_ ? of_unit_(unit) : std::vector<Setting>();
}

void PluginMaker::expect_rtl_of(const std::string& unit,
                                const std::map<std::string, std::int64_t>& known) const {
  for (const rtl_parameter& parameter : wanted_)
    if (parameter.model_of == unit && known.count(parameter.name) == 0)
      throw RtlError("only the model of " + unit + " has " + parameter.what +
                     " so: leave it a model, or the knob at its default");
}

std::vector<PluginMaker::Setting> PluginMaker::settings(const std::string& unit) const {
  std::vector<Setting> all = settings_of_unit(unit);
  for (const rtl_parameter& parameter :
       other_parameters(numbers(read_rtl_syntax(own_sources(unit))), wanted_))
    all.push_back({parameter.name, std::to_string(parameter.value), parameter.what});
  return all;
}

void PluginMaker::tell_missing(const std::string& text, const std::vector<Setting>& settings,
                               const std::map<std::string, std::int64_t>& known) {
  std::set<std::string> told;
  for (const Setting& setting : settings)
    if (known.count(setting.name) == 0 && told.insert(setting.what).second)
      tell(text + " has no parameter " + setting.name + "; " + setting.what + " does not reach it");
}

std::string PluginMaker::own(const std::string& unit, bool open) const {
  return rtl_plugin(own_rtl(unit, open));
}

std::string PluginMaker::with_doors(const std::string& unit,
                                    const std::vector<std::string>& registers) const {
  RtlSources sources = own_rtl(unit);
  sources.doors = registers;
  return rtl_plugin(sources);
}

RtlSources PluginMaker::own_rtl(const std::string& unit, bool open) const {
  expect_rtl_of(unit, {});
  RtlSources sources = own_sources(unit);
  for (const Setting& setting : settings(unit))
    sources.parameters.push_back(setting.name + "=" + setting.value);
  sources.signals = traced_ || open;
  return sources;
}

IslandUnit PluginMaker::island_unit(const std::string& unit, const std::string& instance,
                                    bool back_door) const {
  expect_rtl_of(unit, {});
  IslandUnit one{unit, instance, {}, back_door, read_rtl_syntax(own_sources(unit))};
  for (const Setting& setting : settings(unit))
    one.parameters.push_back(setting.name + "=" + setting.value);
  one.groups = traced_ ? one_group(one.syntax) : comb_groups(own_rtl(unit));
  return one;
}

// Made of the project's files alone: the text that joins them names the plug-in.
std::string PluginMaker::island(const std::vector<IslandUnit>& units) const {
  const std::string text = island_text(units);
  RtlSources sources{IslandTop, {}, {}, {}, {}, {}, RtlSources::Unit, traced_};
  for (const IslandUnit& unit : units) sources.files.push_back(rtl_file(unit.unit));
  sources.files.push_back(
      cached(content_key({text}) + ".sv", [&](const std::string& out) { write_text(out, text); }));
  return rtl_plugin(sources);
}

std::string PluginMaker::users(const std::string& unit, const std::string& text, bool open) const {
  if (fs::path(text).extension() == ".so") {
    if (!fs::exists(text)) return text;
    const auto built = built_parameters(rtl_library(text).model());
    expect_rtl_of(unit, built);
    tell_missing(text, settings(unit), built);
    return text;
  }
  return rtl_plugin(users_rtl(unit, text, open));
}

RtlSources PluginMaker::users_rtl(const std::string& unit, const std::string& text,
                                  bool open) const {
  RtlSources sources = read_source_list(unit, text);
  sources.signals = traced_ || open;
  const RtlSyntax syntax = read_rtl_syntax(sources);
  for (const RtlSyntax::Place& call : syntax.calls)
    tell(call.file + ":" + std::to_string(call.line) + ": " + call.name +
         " reaches beyond the simulation, with your rights");
  const std::map<std::string, std::int64_t> known = numbers(syntax);
  expect_rtl_of(unit, known);
  for (const rtl_parameter& parameter : other_parameters(known, wanted_))
    sources.parameters.push_back(parameter.name + "=" + std::to_string(parameter.value));
  for (const Setting& own : settings_of_unit(unit))
    if (known.count(own.name) != 0) sources.parameters.push_back(own.name + "=" + own.value);
  tell_missing(text, settings(unit), known);
  return sources;
}

RtlSources PluginMaker::gate_sources(const std::string& unit, const GateWord& word) const {
  RtlSources sources = word.file.empty() ? own_rtl(unit) : users_rtl(unit, word.file);
  sources.signals = false;
  return sources;
}

GateNetlist PluginMaker::netlist(const std::string& unit, const GateWord& word) const {
  return gate_netlist(gate_sources(unit, word), word.kind);
}

std::string PluginMaker::gates(const std::string& unit, const GateWord& word, bool open) const {
  return rtl_plugin(simulated_gates(gate_sources(unit, word), word.kind, traced_ || open));
}

std::string PluginMaker::gate_bits(const std::string& unit, const GateWord& word) const {
  return racebeam::gate_bits(gate_sources(unit, word));
}

std::string make_chip_plugin(const std::string& top, const std::vector<std::string>& sources) {
  return rtl_plugin({top, sources, {}, {}, {}, {}, RtlSources::Chip, false});
}

}  // namespace racebeam
