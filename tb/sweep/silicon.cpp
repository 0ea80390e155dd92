// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/silicon.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <filesystem>

#include "tb/base/errors.h"
#include "tb/base/project_folder.h"
#include "tb/base/whole_file.h"
#include "tb/sweep/sweep_kinds.h"
#include "tb/sweep/unit_sources.h"
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
    : engine_(engine),
      yosys_(yosys_version()),
      recipe_(content_key({whole_file(recipe_file())})),
      usual_(engine.parameters(engine.standard(nullptr))),
      known_(usual_.size()) {
  for (const std::string& name : engine.unit_names(false)) {
    if (name == Sound) continue;
    const UnitSources sources = unit_sources(name, rtl_folders());
    Unit unit{name, sources.key, {}};
    for (std::size_t i = 0; i < usual_.size(); ++i) {
      if (sources.parameters.count(usual_[i].name) == 0) continue;
      unit.parameters.push_back(i);
      known_[i] = true;
    }
    units_.push_back(unit);
  }
}

std::vector<UnitParameters> Silicon::units_of(const knob_values& k) const {
  const knob_values usual = engine_.standard(nullptr);
  knob_values inside = k;
  for (std::size_t row = 0; row < k.rows().size(); ++row)
    for (const char* name : sweep_kind(engine_).outside)
      if (std::string(name) == k.rows()[row].name) inside[row] = usual[row];
  const std::vector<rtl_parameter> wanted = engine_.parameters(inside);
  std::vector<std::string> settings;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    settings.push_back(wanted[i].name + "=" + std::to_string(wanted[i].value));
    if (!known_[i] && wanted[i].value != usual_[i].value)
      throw NoSilicon(wanted[i].what + " is of the model only: no unit's RTL has " +
                      settings.back());
  }
  std::vector<UnitParameters> units;
  for (const Unit& unit : units_) {
    UnitParameters own{unit.name, "", ""};
    for (const std::size_t i : unit.parameters) {
      own.parameters += (own.parameters.empty() ? "" : " ") + settings[i];
      if (wanted[i].value != usual_[i].value) own.settings.push_back(settings[i]);
    }
    own.hash =
        content_key({GenericRecipe, recipe_, yosys_, own.unit, own.parameters, unit.sources});
    units.push_back(own);
  }
  return units;
}

}  // namespace racebeam
