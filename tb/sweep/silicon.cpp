// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/silicon.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "sc/beam/knob_parameters.h"
#include "tb/base/errors.h"
#include "tb/base/project_folder.h"
#include "tb/base/whole_file.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/run_tool.h"

namespace racebeam {

namespace {

constexpr const char* Sound = "pwm_sound";
constexpr auto VersionLimit = std::chrono::seconds(60);

std::string yosys_version() {
  ToolResult answer{};
  run_tools({{{"yosys", "-V"}, "", {}, {}}}, 1, VersionLimit,
            [&answer](std::size_t, const ToolResult& result) { answer = result; });
  const std::string line = answer.said.substr(0, answer.said.find('\n'));
  if (answer.late) throw MissingTool("yosys does not answer; does `yosys -V` end?");
  if (!answer.good || line.rfind("Yosys ", 0) != 0)
    throw MissingTool("yosys does not say its version: " + line);
  return line;
}

}  // namespace

std::string recipe_file() {
  std::error_code error;
  const std::string file = project_folder() + "/scripts/netlist";
  if (!std::filesystem::exists(file, error))
    throw MissingTool("racebeam is installed without its RTL: there is no " + file +
                      "; `cmake --install BUILD --component rtl` adds it");
  return file;
}

std::string UnitParameters::text() const {
  return settings.empty() ? unit : fmt::format("{} with {}", unit, fmt::join(settings, " "));
}

Silicon::Silicon(const engine& engine)
    : engine_(engine), yosys_(yosys_version()), recipe_(content_key({whole_file(recipe_file())})) {
  for (const std::string& unit : engine.unit_names(false))
    if (unit != Sound) units_[unit] = unit_sources(unit, rtl_folders());
}

std::vector<UnitParameters> Silicon::units_of(const knobs& k) const {
  const std::vector<rtl_parameter> wanted = engine_.parameters(without_pins(k)),
                                   usual = engine_.parameters(knobs());
  std::vector<UnitParameters> units;
  for (const std::string& name : engine_.unit_names(false))
    if (name != Sound) units.push_back({name, "", ""});
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const rtl_parameter& parameter = wanted[i];
    const std::string setting = fmt::format("{}={}", parameter.name, parameter.value);
    const bool differs = parameter.value != usual[i].value;
    bool known = false;
    for (UnitParameters& unit : units) {
      if (units_.at(unit.unit).parameters.count(parameter.name) == 0) continue;
      known = true;
      unit.parameters += (unit.parameters.empty() ? "" : " ") + setting;
      if (differs) unit.settings.push_back(setting);
    }
    if (differs && !known)
      throw NoSilicon(
          fmt::format("{} is of the model only: no unit's RTL has {}", parameter.what, setting));
  }
  for (UnitParameters& unit : units)
    unit.hash = content_key(
        {GenericRecipe, recipe_, yosys_, unit.unit, unit.parameters, units_.at(unit.unit).key});
  return units;
}

}  // namespace racebeam
