// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_doctor.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/program/doctor_checks.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

struct Report {
  std::vector<Fact> versions = racebeam::versions();
  std::vector<Fact> machine = racebeam::machine();
  std::vector<Check> checks = check_files();
  std::vector<OptionalTool> tools = find_tools();
};

std::string text_of(const Report& report) {
  constexpr const char* Row = "  {:<18} {}\n";
  std::string text = "versions\n";
  for (const Fact& fact : report.versions) text += fmt::format(Row, fact.name, fact.value);
  text += "machine\n";
  for (const Fact& fact : report.machine) text += fmt::format(Row, fact.name, fact.value);
  text += "checks\n";
  for (const Check& check : report.checks)
    text += fmt::format(Row, check.name, check.good ? check.detail : "FAILED: " + check.detail);
  text += "optional tools\n";
  for (const OptionalTool& tool : report.tools) {
    const std::string missing = "not found; " + tool.use + "; apt install " + tool.package;
    text += fmt::format(Row, tool.name, tool.path.empty() ? missing : tool.path);
  }
  return text;
}

std::string json_of(const Report& report) {
  Json json = {{"schema", "racebeam-doctor"}, {"version", 1}};
  for (const Fact& fact : report.versions) json["versions"][fact.name] = fact.value;
  for (const Fact& fact : report.machine) json["machine"][fact.name] = fact.value;
  for (const Check& check : report.checks)
    json["checks"].push_back(
        {{"name", check.name}, {"good", check.good}, {"detail", check.detail}});
  for (const OptionalTool& tool : report.tools)
    json["tools"].push_back({{"name", tool.name},
                             {"found", !tool.path.empty()},
                             {"path", tool.path},
                             {"package", tool.package},
                             {"use", tool.use}});
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

int command_doctor(const DoctorOptions& options) {
  const Report report;
  print(options.json ? json_of(report) : text_of(report));
  for (const Check& check : report.checks)
    if (!check.good)
      throw MissingTool("something required does not work: " + check.name + ": " + check.detail);
  return ExitGood;
}

namespace {

void add_options(const CommandOptions& command, DoctorOptions& options) {
  command.add_flag("--json", options.json, "JSON on stdout instead of the text");
}

}  // namespace

Command doctor_row() {
  return make_command<DoctorOptions>("doctor", "Check the machine and list versions", "Measure",
                                     "doctor", add_options, command_doctor);
}

}  // namespace racebeam
