// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/use_option.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "sc/swap/rtl_library.h"
#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/nearest.h"
#include "tb/scene/engines.h"
#include "tb/twin/twins.h"
#include "tb/verilate/rtl_warnings.h"
#include "tb/verilate/source_list.h"

namespace racebeam {

namespace {

constexpr const char* Beside = "lockstep:";  ///< before a file or gates

/// What comes after "lockstep:", or the text itself.
std::string without_beside(const std::string& text) {
  return text.rfind(Beside, 0) == 0 ? text.substr(std::string(Beside).size()) : text;
}

/// Says what the contract does not know and what may be computed wrongly.
std::string checked(const std::string& plugin) {
  const rtl_library library(plugin);
  warn_of_falling_edges(library.model());
  warn_of_circular_logic(library.model());
  return plugin;
}

}  // namespace

const std::vector<std::string>& own_implementations() {
  static const std::vector<std::string> words = {"model", "rtl", "lockstep", "gates"};
  return words;
}

UseOption::UseOption(const engine& built, const knob_values& k, const scene_tables* scene,
                     bool traced)
    : engine_(built),
      scene_file_(scene != nullptr),
      wired_(twins_of(built).is_top(k, scene)),
      plugins_(twins_of(built).plugins(k, scene, traced)) {}

void UseOption::check_unit(const std::string& unit) const {
  std::vector<std::string> known = engine_.unit_names(scene_file_);
  if (std::find(known.begin(), known.end(), unit) != known.end()) return;
  for (const std::string& other : engine_.unit_names(!scene_file_)) {
    if (other != unit) continue;
    for (const std::string& here : known)
      if (engine_.unit(here)->instance() == engine_.unit(unit)->instance())
        throw UsageError(unit + " is not in this chip: " +
                         (scene_file_ ? "a scene file has " : "the built-in demo has ") + here +
                         " in its place");
  }
  for (const engine* other : engines())
    if (other->unit(unit))
      throw UsageError(
          fmt::format("{} is a unit of {}, and this chip is {}; add --engine {}, or "
                      "give a scene of it",
                      unit, other->name, engine_.name, other->name));
  known.push_back(AllUnits);
  throw unknown_name("unit", unit, known);
}

unit_choice UseOption::choice_of(const std::string& unit, const std::string& text) const {
  if (text == "model") return {};
  const bool open = unit == engine_.top;  // the check of its wiring looks at the units inside
  if (text == "rtl") return {unit_choice::Rtl, false, ""};
  if (text == "lockstep") return {unit_choice::Model, true, plugins_.own(unit, open)};
  const std::string file = without_beside(text);
  const bool beside = file.size() < text.size();
  const auto driver = beside ? unit_choice::Model : unit_choice::Rtl;
  if (const auto gates = gate_word(file)) {
    if (open && gates->kind != GenericGates)
      tell(unit + " as " + gates->kind +
           " is one module without the units' names: compare its first frame, --frames 1");
    return {driver, beside, checked(plugins_.gates(unit, *gates, open))};
  }
  if (is_source_list(file) || std::filesystem::path(file).extension() == ".so")
    return {driver, beside, checked(plugins_.users(unit, file, open))};
  std::vector<std::string> known = own_implementations();
  for (const char* file : {"gates:osu018", "gates:FILE.sv", "FILE.sv", "FILE.sv+FILE.sv", "LIST.f",
                           "FOLDER", "FILE.so", "lockstep:gates", "lockstep:FILE.sv"})
    known.emplace_back(file);
  throw unknown_name("implementation", text, known);
}

void UseOption::use_one(unit_choices& choices, const std::string& text, bool beside) const {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    throw UsageError("'" + text +
                     "' is not of the form UNIT=model, UNIT=rtl, UNIT=lockstep, UNIT=gates or "
                     "UNIT=FILE.sv");
  const std::string unit = text.substr(0, equals), how = text.substr(equals + 1);
  if (unit != AllUnits) {
    if (unit == engine_.top) check_use_of_chip(how, beside);
    else check_unit(unit);
    choices.by_unit[unit] = choice_of(unit, how);
    return;
  }
  const auto gates = gate_word(without_beside(how));
  if ((!gates || !gates->file.empty()) && how != "model" && how != "rtl" && how != "lockstep")
    throw UsageError("all=" + how +
                     ": all units can be model, rtl, lockstep, gates, gates:osu018, "
                     "lockstep:gates or lockstep:gates:osu018; a file is for one");
  for (const std::string& each : engine_.unit_names(scene_file_))
    choices.by_unit[each] = choice_of(each, how);
  // Flattened gates cannot be put into a later frame.
  const bool flat = gates && gates->kind != GenericGates;
  if ((beside || how.rfind("lockstep", 0) == 0) && wired_ && !flat)
    choices.by_unit[engine_.top] = choice_of(engine_.top, how);
}

std::string UseOption::gate_bits(const std::string& unit, const std::string& how) const {
  const auto gates = gate_word(how);
  if (!gates || gates->kind != GenericGates) return "";
  try {
    return plugins_.gate_bits(unit, *gates);
  } catch (const RtlError&) {
    return "";
  }
}

void UseOption::check_use_of_chip(const std::string& how, bool beside) const {
  if (how == "model" || how == "rtl" || (!beside && gate_word(how)))
    throw UsageError(fmt::format(
        "{0} is all units in RTL and their wires: it runs beside the chip only, as {0}=lockstep; "
        "for {1} in the chip write all={2}",
        engine_.top, gate_word(how) ? "gates" : "RTL", gate_word(how) ? how : "rtl"));
  check_whole_chip();
}

void UseOption::check_whole_chip() const {
  if (!wired_)
    throw UsageError(
        std::string(engine_.top) +
        " is the taped-out chip with its own demo; leave out the scene file and --set");
}

void UseOption::use(unit_choices& choices, const std::string& text) const {
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) use_one(choices, part, false);
}

void UseOption::join(unit_choices& choices, bool islands) const {
  const Twins& row = twins_of(engine_);
  std::vector<IslandUnit> own;
  for (const auto& [unit, choice] : choices.by_unit)
    if (choice.driver == unit_choice::Rtl && choice.plugin.empty())
      own.push_back(plugins_.island_unit(
          unit, engine_.unit(unit)->instance(),
          std::count(row.back_doors.begin(), row.back_doors.end(), unit) != 0));
  if (islands && row.has_islands)
    for (const std::vector<std::size_t>& numbers : islands_among(own)) {
      std::vector<IslandUnit> units;
      for (const std::size_t number : numbers) units.push_back(own[number]);
      const std::string plugin = plugins_.island(units);
      for (const IslandUnit& unit : units) choices.by_unit[unit.unit].island = plugin;
    }
  for (const IslandUnit& unit : own)
    if (unit_choice& choice = choices.by_unit[unit.unit]; choice.island.empty())
      choice.plugin = plugins_.own(unit.unit);
}

void UseOption::lockstep(unit_choices& choices, const std::string& text) const {
  const auto equals = text.find('=');
  const std::string how = equals == std::string::npos ? "rtl" : text.substr(equals + 1);
  if (how == "rtl") return use_one(choices, text.substr(0, equals) + "=lockstep", true);
  if (how == "model")
    throw UsageError(text + ": nothing is beside the model; write " + text.substr(0, equals) +
                     " for its RTL, or the file to compare with it");
  unit_choices told;
  use_one(told, text, true);
  for (auto& [unit, choice] : told.by_unit)
    choices.by_unit[unit] = {unit_choice::Model, true, choice.plugin};
}

}  // namespace racebeam
