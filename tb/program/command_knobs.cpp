// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_knobs.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "sc/beam/knobs.h"
#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/show/knobs_json.h"

namespace racebeam {

namespace {

constexpr const char* Row = "{:<23} {:<8} {:<16} {:<8} {:<68} {}\n";

std::string table() {
  const knobs defaults;
  std::string of_user, of_scene;
  for (const knob_info& row : knob_table())
    (row.of_scene ? of_scene : of_user) +=
        fmt::format(Row, row.name, row.text(defaults.*row.member), row.range(), row.unit,
                    row.meaning, row.source);
  return fmt::format(Row, "knob", "default", "range", "unit", "meaning", "source") + of_user +
         "\nset by the scene file only:\n" + of_scene;
}

nlohmann::ordered_json json_of(const knob_info& row) {
  nlohmann::ordered_json json = {{"name", row.name},
                                 {"default", knob_json(row, knobs().*row.member)}};
  if (row.names.empty()) {
    json["min"] = row.min;
    json["max"] = row.max;
  } else {
    json["values"] = row.names;
  }
  json["unit"] = row.unit;
  json["meaning"] = row.meaning;
  json["source"] = row.source;
  return json;
}

std::string json_table() {
  nlohmann::ordered_json all = {{"schema", "racebeam-knobs"},
                                {"version", 1},
                                {"knobs", nlohmann::ordered_json::array()},
                                {"scene_knobs", nlohmann::ordered_json::array()}};
  for (const knob_info& row : knob_table())
    all[row.of_scene ? "scene_knobs" : "knobs"].push_back(json_of(row));
  return all.dump(2) + "\n";
}

}  // namespace

int command_knobs(const KnobsOptions& options) {
  print(options.json ? json_table() : table());
  return ExitGood;
}

namespace {

void add_options(const CommandOptions& command, KnobsOptions& options) {
  command.add_flag("--json", options.json, "JSON on stdout instead of the table");
}

}  // namespace

Command knobs_row() {
  return make_command<KnobsOptions>("knobs", "List what --set may change", "Measure", "knobs",
                                    add_options, command_knobs);
}

}  // namespace racebeam
