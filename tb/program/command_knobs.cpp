// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_knobs.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/program/common_options.h"
#include "tb/scene/engines.h"
#include "tb/show/knobs_json.h"
#include "tb/show/open_show.h"

namespace racebeam {

namespace {

constexpr const char* Row = "{:<23} {:<8} {:<16} {:<8} {:<68} {}\n";

std::string table(const std::vector<knob_row>& rows) {
  std::string of_user, of_scene;
  for (const knob_row& row : rows)
    (row.of_scene ? of_scene : of_user) += fmt::format(
        Row, row.name, row.text(row.standard), row.range(), row.unit, row.meaning, row.source);
  return fmt::format(Row, "knob", "default", "range", "unit", "meaning", "source") + of_user +
         "\nset by the scene file only:\n" + of_scene;
}

nlohmann::ordered_json json_of(const knob_row& row) {
  nlohmann::ordered_json json = {{"name", row.name}, {"default", knob_json(row, row.standard)}};
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

std::string json_table(const engine& one) {
  nlohmann::ordered_json all = {{"schema", "racebeam-knobs"},
                                {"version", 1},
                                {"engine", one.name},
                                {"knobs", nlohmann::ordered_json::array()},
                                {"scene_knobs", nlohmann::ordered_json::array()}};
  for (const knob_row& row : one.knobs)
    all[row.of_scene ? "scene_knobs" : "knobs"].push_back(json_of(row));
  return all.dump(2) + "\n";
}

}  // namespace

int command_knobs(const KnobsOptions& options) {
  const engine& one = options.engine.empty() ? *engines().front() : engine_named(options.engine);
  print(options.json ? json_table(one) : table(one.knobs));
  return ExitGood;
}

namespace {

void add_options(const CommandOptions& command, KnobsOptions& options) {
  add_engine_option(command, options.engine, "Of this engine");
  command.add_flag("--json", options.json, "JSON on stdout instead of the table");
}

}  // namespace

Command knobs_row() {
  return make_command<KnobsOptions>("knobs", "List what --set may change", "Measure", "knobs",
                                    add_options, command_knobs);
}

}  // namespace racebeam
