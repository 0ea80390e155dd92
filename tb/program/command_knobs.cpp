// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_knobs.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "sc/base/knobs.h"
#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/show/knobs_json.h"

namespace racebeam {

namespace {

constexpr const char* Row = "{:<23} {:<8} {:<16} {:<8} {:<68} {}\n";

std::string table() {
  std::string text = fmt::format(Row, "knob", "default", "range", "unit", "meaning", "source");
  const knobs defaults;
  for (const knob_info& row : knob_table())
    text += fmt::format(Row, row.name, row.text(defaults.*row.member), row.range(), row.unit,
                        row.meaning, row.source);
  return text;
}

std::string json_table() {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  const knobs defaults;
  for (const knob_info& row : knob_table()) {
    nlohmann::ordered_json json = {{"name", row.name},
                                   {"default", knob_json(row, defaults.*row.member)}};
    if (row.names.empty()) {
      json["min"] = row.min;
      json["max"] = row.max;
    } else {
      json["values"] = row.names;
    }
    json["unit"] = row.unit;
    json["meaning"] = row.meaning;
    json["source"] = row.source;
    rows.push_back(json);
  }
  return nlohmann::ordered_json{{"schema", "racebeam-knobs"}, {"version", 1}, {"knobs", rows}}.dump(
             2) +
         "\n";
}

}  // namespace

int command_knobs(const KnobsOptions& options) {
  print(options.json ? json_table() : table());
  return ExitGood;
}

namespace {

void add_options(CLI::App& command, KnobsOptions& options) {
  command.add_flag("--json", options.json, "JSON on stdout instead of the table");
}

}  // namespace

Command knobs_row() {
  return make_command<KnobsOptions>("knobs", "List what --set may change", "Measure", "knobs",
                                    add_options, command_knobs);
}

}  // namespace racebeam
