// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/replay_part.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tb/base/console.h"
#include "tb/base/content_hash.h"
#include "tb/base/output_file.h"
#include "tb/base/whole_file.h"
#include "tb/program/verify_report.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

Json content(const ReplayPart& part, const std::string& key, const Json& verdict) {
  return {{"schema", "racebeam-replay-part"},
          {"version", 1},
          {"first", part.first},
          {"frames", part.frames},
          {"key", key},
          {"verdict", verdict}};
}

}  // namespace

std::string ReplayPart::file() const { return fmt::format("frames_{:05}_{}.json", first, frames); }

void write_part(const std::string& folder, const ReplayPart& part, const std::string& key,
                const UnitVerdict& verdict) {
  Json json = content(part, key, to_json(verdict));
  json["sum"] = content_hash(json.dump());
  write_text(folder + "/" + part.file(), json.dump(2) + "\n");
}

std::optional<UnitVerdict> read_part(const std::string& folder, const ReplayPart& part,
                                     const std::string& key) {
  const std::string path = folder + "/" + part.file();
  if (!std::filesystem::exists(path)) return std::nullopt;
  try {
    Json json = Json::parse(whole_file(path));
    const std::string sum = json.at("sum");
    json.erase("sum");
    const Json verdict = json.at("verdict");
    if (sum == content_hash(json.dump()) && json == content(part, key, verdict))
      return verdict_of(verdict);
  } catch (const std::exception&) {  // no JSON, or not this
  }
  tell(path + " is damaged: these frames are compared again");
  return std::nullopt;
}

}  // namespace racebeam
