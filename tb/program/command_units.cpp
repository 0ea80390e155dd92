// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_units.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/project_folder.h"
#include "tb/program/common_options.h"
#include "tb/program/unit_areas.h"
#include "tb/scene/engines.h"
#include "tb/show/open_show.h"

namespace racebeam {

namespace {

constexpr const char* Row = "{:<18} {:<20} {:<7} {}\n";

const char* shows_text(unit_row::use shows) {
  switch (shows) {
    case unit_row::Demo: return "demo";
    case unit_row::SceneFile: return "scenes";
    default: return "all";
  }
}

/// Nothing where no RTL is installed.
std::string rtl_text(const unit_row& row) try {
  const std::string file = rtl_file(row.name);
  std::error_code error;
  return std::filesystem::exists(file, error) ? file : "";
} catch (const MissingTool&) {
  return "";
}

std::string table(const engine& one) {
  std::string text = fmt::format(Row, "unit", "instance", "shows", "RTL");
  for (const unit_row& row : one.units)
    text += fmt::format(Row, row.name, row.instance(), shows_text(row.shows), rtl_text(row));
  return text;
}

std::string json_table(const engine& one) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const unit_row& row : one.units)
    rows.push_back({{"name", row.name},
                    {"slot", row.slot},
                    {"instance", row.instance()},
                    {"shows", shows_text(row.shows)},
                    {"rtl", rtl_text(row)}});
  return nlohmann::ordered_json{
             {"schema", "racebeam-units"}, {"version", 1}, {"engine", one.name}, {"units", rows}}
             .dump(2) +
         "\n";
}

}  // namespace

int command_units(const UnitsOptions& options) {
  const engine& one = options.engine.empty() ? *engines().front() : engine_named(options.engine);
  if (!options.area && !options.units.empty())
    throw UsageError("units takes names of units with --area only; write racebeam units --area " +
                     options.units.front());
  if (options.area) {
    const std::vector<UnitArea> areas = areas_of(one, options.units);
    print(options.json ? area_json(one, areas) : area_table(areas));
    return ExitGood;
  }
  print(options.json ? json_table(one) : table(one));
  return ExitGood;
}

namespace {

void add_options(const CommandOptions& command, UnitsOptions& options) {
  command
      .add_option("unit", options.units,
                  "Units whose gates are counted, and the whole chip's name; all if none is given")
      .type_name("UNIT");
  add_engine_option(command, options.engine, "Of this engine");
  command.add_flag("--area", options.area,
                   "Flip-flops, cells, area and slack as gates of osu018: yosys, OpenSTA");
  command.add_flag("--json", options.json, "JSON on stdout instead of the table");
}

}  // namespace

Command units_row() {
  return make_command<UnitsOptions>("units", "List the units of the chip, and their RTL", "Verify",
                                    "units", add_options, command_units);
}

}  // namespace racebeam
