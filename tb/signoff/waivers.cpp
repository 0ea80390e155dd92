// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/waivers.h"

#include <filesystem>
#include <utility>

#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/base/project_folder.h"
#include "tb/base/text_pattern.h"
#include "tb/scene/input_file.h"
#include "tb/scene/table_reader.h"

namespace racebeam {

namespace {

const std::vector<FileKey>& waiver_keys() {
  static const std::vector<FileKey> keys = {
      {"", "waiver", "tables", "none", "a mutant that nobody could decide; repeatable"},
      {"waiver", "unit", "name", "required", "of the mutant"},
      {"waiver", "mutant", "text", "required", "its name, as the page has it"},
      {"waiver", "reason", "text", "required", "why it need not be found"},
      {"waiver", "reviewer", "text", "required", "who has looked at it"},
      {"waiver", "date", "text", "required", "when: \"2026-11-23\""},
  };
  return keys;
}

/// A text of any length; one of blanks is none.
void read_sentence(const TableReader& table, const std::string& key, std::string& to) {
  const TomlNode* node = table.find(key);
  if (!node) return;
  if (node->kind != TomlNode::String) return wrong_type(*node, key, "a text", table.faults());
  if (node->text.find_first_not_of(" \t\n") != std::string::npos) to = node->text;
}

Waiver read_waiver(const TomlNode& node, const std::string& path, Faults& faults) {
  static const TextPattern Day("[0-9]{4}-[0-9]{2}-[0-9]{2}");
  const TableReader table(node, "waiver", faults, waiver_keys());
  Waiver waiver;
  waiver.place = path + ":" + std::to_string(node.place.line);
  table.require("unit", "the unit's name: unit = \"stacks\"");
  table.require("mutant", "as the page has it: mutant = \"inv $procmux$85 Y[5]\"");
  for (const auto& [key, to] : {std::pair{"unit", &waiver.unit},
                                {"mutant", &waiver.mutant},
                                {"reason", &waiver.reason},
                                {"reviewer", &waiver.reviewer},
                                {"date", &waiver.date}})
    read_sentence(table, key, *to);
  if (waiver.reason.empty()) waiver.fault = "has no reason";
  else if (waiver.reviewer.empty()) waiver.fault = "has no reviewer";
  else if (!Day.matches(waiver.date)) waiver.fault = "has no date such as 2026-11-23";
  return waiver;
}

}  // namespace

std::vector<Waiver> read_waivers(const std::string& path) {
  Faults faults;
  std::vector<Waiver> waivers;
  if (!std::filesystem::exists(path)) throw UsageError("there is no file " + path);
  const auto text = read_input_file(path, "list of waivers", faults);
  if (const auto root = text ? parse_toml(*text, faults) : std::nullopt) {
    const TableReader top(*root, "", faults, waiver_keys());
    if (const TomlNode* list = top.find("waiver")) {
      if (list->kind != TomlNode::Array)
        wrong_type(*list, "waiver", "written below a line [[waiver]]", faults);
      for (const TomlNode& node : list->items) waivers.push_back(read_waiver(node, path, faults));
    }
  }
  if (!faults.none())
    throw UsageError(counted(faults.count(), "fault") + " in " + path + "\n" + faults.text(path));
  return waivers;
}

std::string own_waivers_file() { return project_folder() + "/tb/signoff/waivers.toml"; }

}  // namespace racebeam
