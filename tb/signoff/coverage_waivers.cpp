// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/coverage_waivers.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <utility>

#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/base/project_folder.h"
#include "tb/base/text_pattern.h"
#include "tb/base/whole_file.h"
#include "tb/scene/table_reader.h"

namespace racebeam {

namespace {

const std::vector<FileKey>& waiver_keys() {
  static const std::vector<FileKey> keys = {
      {"", "waiver", "tables", "required", "points that need not be hit; repeatable"},
      {"waiver", "units", "texts", "required", "the units under test"},
      {"waiver", "kind", "line, branch, toggle", "required", "of all its points"},
      {"waiver", "module", "text", "required", "the RTL module that they are in"},
      {"waiver", "points", "texts", "required", "the points, as the list of missing ones has them"},
      {"waiver", "when", "condition", "none", "over the RTL's parameters: elsewhere it is void"},
      {"waiver", "reason", "text", "required", "why they cannot be hit, or need not"},
  };
  return keys;
}

void read_text(const TableReader& table, const std::string& key, const char* help,
               std::string& to) {
  const TomlNode* node = help ? table.require(key, help) : table.find(key);
  if (!node) return;
  if (node->kind != TomlNode::String) return wrong_type(*node, key, "a text", table.faults());
  to = node->text;
  if (to.find_first_not_of(" \t\n") == std::string::npos)
    table.faults().add(node->place, "'" + key + "' is empty", help ? help : "leave it out");
}

void read_texts(const TableReader& table, const std::string& key, const char* help,
                std::vector<std::string>& to) {
  const TomlNode* node = table.require(key, help);
  if (!node) return;
  if (node->kind != TomlNode::Array) return wrong_type(*node, key, "texts", table.faults());
  if (node->items.empty()) table.faults().add(node->place, "'" + key + "' is empty", help);
  for (const TomlNode& item : node->items) {
    if (item.kind != TomlNode::String) wrong_type(item, key, "texts", table.faults());
    else to.push_back(item.text);
  }
}

CoverageWaiver read_waiver(const TomlNode& node, Faults& faults) {
  const TableReader table(node, "waiver", faults, waiver_keys());
  CoverageWaiver waiver;
  waiver.place = node.place;
  if (node.kind != TomlNode::Table) return waiver;
  read_texts(table, "units", "units = [\"stacks\"]", waiver.units);
  table.require("kind", "kind = \"line\", \"branch\" or \"toggle\"");
  int kind = waiver.kind;
  table.read_choice("kind", {"line", "branch", "toggle"}, kind);
  waiver.kind = static_cast<CoveragePoint::Kind>(kind);
  read_text(table, "module", "module = \"stacks\"", waiver.module);
  read_texts(table, "points", "points = [\"sp_i[5:2]\"]", waiver.points);
  read_text(table, "when", nullptr, waiver.when);
  read_text(table, "reason", "say why: reason = \"...\"", waiver.reason);
  return waiver;
}

std::vector<CoverageWaiver> waivers_of(const std::string& file) {
  WaiversResult result = read_coverage_waivers(whole_file(file));
  if (result.faults.none()) return std::move(result.waivers);
  std::fputs(result.faults.text(file).c_str(), stderr);
  throw UsageError(counted(result.faults.count(), "fault") + " in " + file);
}

}  // namespace

WaiversResult read_coverage_waivers(std::string_view text) {
  WaiversResult result;
  const std::optional<TomlNode> root = parse_toml(text, result.faults);
  if (!root) return result;
  const TableReader top(*root, "", result.faults, waiver_keys());
  const TomlNode* waivers = top.find("waiver");
  if (!waivers) return result;
  if (waivers->kind != TomlNode::Array)
    wrong_type(*waivers, "waiver", "written below a line [[waiver]]", result.faults);
  for (const TomlNode& waiver : waivers->items)
    result.waivers.push_back(read_waiver(waiver, result.faults));
  return result;
}

std::string own_coverage_waivers() { return project_folder() + "/tb/signoff/coverage_waivers"; }

std::vector<CoverageWaiver> load_coverage_waivers(const std::string& path) {
  namespace fs = std::filesystem;
  const std::string from = path.empty() ? own_coverage_waivers() : path;
  if (!fs::exists(from)) {
    if (!path.empty()) throw UsageError("there is no file of waivers " + path);
    throw MissingTool("there is no " + from + ": install racebeam with its waivers");
  }
  if (!fs::is_directory(from)) return waivers_of(from);
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(from))
    if (entry.path().extension() == ".toml") files.insert(entry.path());
  std::vector<CoverageWaiver> all;
  for (const fs::path& file : files)
    for (CoverageWaiver& waiver : waivers_of(file.string())) {
      waiver.file = file.filename().string();
      all.push_back(std::move(waiver));
    }
  return all;
}

bool names_point(const std::string& wanted, const CoveragePoint& point, int& number) {
  const std::string title = point.title();
  if (wanted == title) return true;
  if (point.kind != CoveragePoint::Toggle) {
    static const TextPattern Numbered("#([0-9]+) (.*)");
    const TextPattern::Groups numbered = Numbered.match(wanted);
    return !numbered.empty() && numbered[2] == title && ++number == std::atoi(numbered[1].c_str());
  }
  if (title.rfind(wanted + "[", 0) == 0) return true;
  static const TextPattern Range("(.*)\\[([0-9]+):([0-9]+)\\]"), Bit("(.*)\\[([0-9]+)\\]");
  const TextPattern::Groups range = Range.match(wanted), bit = Bit.match(title);
  if (range.empty() || bit.empty() || range[1] != bit[1]) return false;
  const int high = std::atoi(range[2].c_str()), low = std::atoi(range[3].c_str());
  const int at = std::atoi(bit[2].c_str());
  return std::min(low, high) <= at && at <= std::max(low, high);
}

}  // namespace racebeam
