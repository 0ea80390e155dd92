// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/silicon.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "tb/base/project_folder.h"
#include "tb/base/whole_file.h"
#include "tb/sweep/sweep_kinds.h"
#include "tb/sweep/unit_sources.h"
#include "tb/verilate/cache_folder.h"

namespace racebeam {

namespace {

std::string text_of(const rtl_parameter& parameter) {
  return parameter.name + "=" + std::to_string(parameter.value);
}

}  // namespace

std::string UnitParameters::text() const {
  return settings.empty() ? unit : fmt::format("{} with {}", unit, fmt::join(settings, " "));
}

Silicon::Silicon(const engine& engine)
    : engine_(engine),
      yosys_(yosys_version()),
      recipe_(content_key({whole_file(recipe_file())})),
      usual_(engine.parameters(engine.standard(nullptr))),
      known_(usual_.size()) {
  if (*engine.top) top_ = unit_named(engine.top);
  for (const std::string& name : engine.unit_names(false)) {
    if (name == Sound) continue;
    units_.push_back(unit_named(name));
    for (const std::size_t i : units_.back().parameters) known_[i] = true;
  }
}

Silicon::Unit Silicon::unit_named(const std::string& name) const {
  const UnitSources sources = unit_sources(name, rtl_folders());
  Unit unit{name, sources.key, {}};
  for (std::size_t i = 0; i < usual_.size(); ++i)
    if (sources.parameters.count(usual_[i].name) != 0) unit.parameters.push_back(i);
  return unit;
}

std::vector<rtl_parameter> Silicon::parameters_of(const knob_values& k) const {
  const knob_values usual = engine_.standard(nullptr);
  knob_values inside = k;
  for (std::size_t row = 0; row < k.rows().size(); ++row)
    for (const char* name : sweep_kind(engine_).outside)
      if (std::string(name) == k.rows()[row].name) inside[row] = usual[row];
  return engine_.parameters(inside);
}

UnitParameters Silicon::with(const Unit& unit, const std::vector<rtl_parameter>& wanted) const {
  UnitParameters own{unit.name, "", ""};
  for (const std::size_t i : unit.parameters) {
    const std::string setting = text_of(wanted[i]);
    own.parameters += (own.parameters.empty() ? "" : " ") + setting;
    if (wanted[i].value != usual_[i].value) own.settings.push_back(setting);
  }
  own.hash = content_key({GenericRecipe, recipe_, yosys_, own.unit, own.parameters, unit.sources});
  return own;
}

std::vector<UnitParameters> Silicon::units_of(const knob_values& k) const {
  const std::vector<rtl_parameter> wanted = parameters_of(k);
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (!known_[i] && wanted[i].value != usual_[i].value)
      throw NoSilicon(wanted[i].what + " is of the model only: no unit's RTL has " +
                      text_of(wanted[i]));
  std::vector<UnitParameters> units;
  for (const Unit& unit : units_) units.push_back(with(unit, wanted));
  return units;
}

UnitParameters Silicon::chip_of(const knob_values& k) const {
  if (top_.name.empty())
    throw NoSilicon(std::string(engine_.name) + " has no RTL of a whole chip that takes knobs");
  const std::vector<rtl_parameter> wanted = parameters_of(k);
  const auto& known = top_.parameters;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i].value != usual_[i].value && std::count(known.begin(), known.end(), i) == 0)
      throw NoSilicon(wanted[i].what + " is none of the whole chip: " + top_.name + " has no " +
                      text_of(wanted[i]));
  return with(top_, wanted);
}

}  // namespace racebeam
