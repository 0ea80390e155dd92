// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/replay_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tb/base/errors.h"
#include "tb/base/output_file.h"
#include "tb/base/whole_file.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

/// What follows the word at the start of a line.
std::string line_of(const std::string& key, const std::string& word) {
  std::istringstream lines(key);
  for (std::string line; std::getline(lines, line);)
    if (line.rfind(word + " ", 0) == 0) return line.substr(word.size() + 1);
  return "";
}

Json to_json(const ReplayRow& row) {
  Json json = {{"engine", row.engine},
               {"scene", row.scene},
               {"unit", row.unit},
               {"level", row.level},
               {"frames", row.frames},
               {"clocks", row.clocks},
               {"differences", row.differences},
               {"model", row.model},
               {"rtl", row.rtl},
               {"command", row.command}};
  if (!row.fault.empty()) json["fault"] = row.fault;
  return json;
}

ReplayRow row_of(const Json& json) {
  return {json.at("engine"), json.at("scene"),  json.at("unit"),        json.at("level"),
          json.at("frames"), json.at("clocks"), json.at("differences"), json.value("fault", ""),
          json.at("model"),  json.at("rtl"),    json.at("command")};
}

}  // namespace

ReplayRow replay_row(const TrafficHead& head, const std::string& word, const std::string& key,
                     int frames, const UnitVerdict& verdict, const std::string& run_text) {
  const auto equals = word.find('=');
  return {head.engine,
          head.scene,
          head.unit,
          equals == std::string::npos ? "rtl" : word.substr(equals + 1),
          frames,
          verdict.clocks,
          verdict.differences,
          verdict.fault,
          line_of(key, "model"),
          line_of(key, "RTL"),
          "racebeam verify " + word + run_text};
}

std::vector<ReplayRow> read_replay_record(const std::string& path) {
  std::vector<ReplayRow> rows;
  if (!std::filesystem::exists(path)) return rows;
  try {
    for (const Json& row : Json::parse(whole_file(path))) rows.push_back(row_of(row));
  } catch (const Json::exception&) {
    throw UsageError(path + " holds no record of replays; choose another file for --record");
  }
  return rows;
}

void write_replay_record(const std::string& path, const std::vector<ReplayRow>& rows) {
  std::vector<ReplayRow> all = read_replay_record(path);
  for (const ReplayRow& row : rows) {
    const auto same = std::find_if(
        all.begin(), all.end(), [&](const ReplayRow& old) { return old.command == row.command; });
    if (same != all.end()) *same = row;
    else all.push_back(row);
  }
  std::string text;
  for (const ReplayRow& row : all) text += (text.empty() ? "[" : ",\n ") + to_json(row).dump();
  write_text(path, text + "]\n");
}

}  // namespace racebeam
