// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/manifest.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tb/base/errors.h"
#include "tb/base/version.h"
#include "tb/show/knobs_json.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* Schema = "racebeam-manifest";

Json units_json(const std::map<std::string, ManifestUnit>& units) {
  Json json = Json::object();
  for (const auto& [name, unit] : units)
    json[name] = {{"implementation", unit.implementation}, {"files", unit.files}};
  return json;
}

// File names and arguments need not be UTF-8; JSON must be.
std::string dump(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

// "knobs.dr_bits": value, of everything below `json`.
std::map<std::string, std::string> by_path(const Json& json) {
  std::map<std::string, std::string> values;
  const Json flat = json.flatten();
  for (const auto& [path, value] : flat.items()) {
    if (value.is_null()) continue;  // nothing, or no entries
    std::string name = path.substr(1);
    std::replace(name.begin(), name.end(), '/', '.');
    for (const auto& [code, is] : {std::pair{"~1", "/"}, {"~0", "~"}})  // of JSON pointers
      for (std::size_t at = 0; (at = name.find(code, at)) != std::string::npos; ++at)
        name.replace(at, 2, is);
    values[name] = value.is_string() ? value.get<std::string>() : value.dump();
  }
  return values;
}

Json parse(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || json.value("schema", Json()) != Schema)
    throw UsageError("it is no manifest of a render");
  return json;
}

}  // namespace

Json Manifest::settings() const {
  return {{"scene", scene},
          {"scene_hash", scene_hash},
          {"level", level},
          {"knobs", k ? knobs_json(*k) : Json()},
          {"units", units_json(units)},
          {"inputs", inputs},
          {"channels", channels}};
}

std::string Manifest::text() const {
  Json json = {{"schema", Schema}, {"schema_version", 1}, {"version", program_version()}};
  json.update(settings());
  json.update(Json{{"command", command},
                   {"first_frame", first_frame},
                   {"every", every},
                   {"frames_wanted", frames_wanted},
                   {"frames_rendered", frames_rendered},
                   {"complete", frames_rendered == frames_wanted},
                   {"earlier_commands", earlier_commands},
                   {"frames", frames},
                   {"files", files}});
  return dump(json, 2) + "\n";
}

std::vector<std::string> Manifest::differences(const std::string& old) const {
  const Json before = parse(old);
  // As it would be read back, so that what is no UTF-8 agrees with itself.
  const Json now = Json::parse(dump(settings(), -1));
  Json known = Json::object();
  for (const auto& [key, value] : now.items()) known[key] = before.value(key, Json());
  std::map<std::string, std::string> is = by_path(now), was = by_path(known);
  std::vector<std::string> all;
  for (const auto& [path, value] : is)
    if (was[path] != value)
      all.push_back(path + ": " + (was[path].empty() ? "nothing" : was[path]) + ", now " + value);
  for (const auto& [path, value] : was)
    if (!value.empty() && !is.count(path)) all.push_back(path + ": " + value + ", now nothing");
  return all;
}

void Manifest::add_earlier(const std::string& old) {
  const Json before = parse(old);
  try {
    frames.merge(before.value("frames", std::set<int>()));
    std::vector<std::string> all = before.value("files", std::vector<std::string>());
    std::set<std::string> known(all.begin(), all.end());
    for (const std::string& file : files)
      if (known.insert(file).second) all.push_back(file);
    files = all;
    std::vector<std::vector<std::string>> commands =
        before.value("earlier_commands", std::vector<std::vector<std::string>>());
    const auto last = before.value("command", std::vector<std::string>());
    if (std::find(commands.begin(), commands.end(), last) == commands.end())
      commands.push_back(last);
    earlier_commands = commands;
  } catch (const nlohmann::json::exception&) {
    throw UsageError("it is no manifest of a render");
  }
}

}  // namespace racebeam
