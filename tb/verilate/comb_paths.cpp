// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/comb_paths.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <vector>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/project_folder.h"
#include "tb/base/whole_file.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/rtl_syntax.h"
#include "tb/verilate/run_tool.h"
#include "tb/verilate/yosys.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

constexpr auto Limit = std::chrono::seconds(120);  // for yosys
constexpr const char* Recipe = "2";                // another one whenever the answer may be another

/// Where a cell's outputs follow from at once. A register's follow from its clock and from what
/// sets it without one: that is how a clock made of inputs is found.
bool passes(const std::string& type, const std::string& port, bool clocked) {
  static const std::set<std::string> Held = {"D", "EN", "SRST"};
  if (type.rfind("$dff", 0) == 0 || type.rfind("$sdff", 0) == 0 || type.rfind("$adff", 0) == 0 ||
      type.rfind("$aldff", 0) == 0)
    return Held.count(port) == 0;
  if (type.rfind("$memrd", 0) == 0 && clocked) return port == "CLK" || port == "ARST";
  return true;
}

/// Bits of nets are numbers; constants are texts.
std::vector<int> nets_of(const Json& bits) {
  std::vector<int> nets;
  for (const Json& bit : bits)
    if (bit.is_number_integer()) nets.push_back(bit.get<int>());
  return nets;
}

bool is_clocked(const Json& cell) {
  const std::string value = cell.value("parameters", Json::object()).value("CLK_ENABLE", "");
  return value.find('1') != std::string::npos;
}

/// Nets that a net moves at once.
std::map<int, std::vector<int>> moved_by(const Json& cells) {
  std::map<int, std::vector<int>> moved;
  for (const auto& item : cells.items()) {
    const Json& cell = item.value();
    const std::string type = cell.at("type");
    const bool clocked = is_clocked(cell);
    if (type.rfind("$memwr", 0) == 0 && !clocked) throw RtlError("a memory without a clock");
    std::vector<int> from, to;
    for (const auto& port : cell.at("port_directions").items()) {
      const std::vector<int> nets = nets_of(cell.at("connections").at(port.key()));
      auto& side = port.value() == "input" ? from : to;
      if (port.value() != "input" || passes(type, port.key(), clocked))
        side.insert(side.end(), nets.begin(), nets.end());
    }
    for (const int net : from) {
      auto& all = moved[net];
      all.insert(all.end(), to.begin(), to.end());
    }
  }
  return moved;
}

/// All nets that one of these moves, they themselves among them.
std::set<int> moved_from(std::vector<int> nets, const std::map<int, std::vector<int>>& moved) {
  std::set<int> seen(nets.begin(), nets.end());
  while (!nets.empty()) {
    const int net = nets.back();
    nets.pop_back();
    const auto next = moved.find(net);
    if (next == moved.end()) continue;
    for (const int one : next->second)
      if (seen.insert(one).second) nets.push_back(one);
  }
  return seen;
}

/// Whether a file asks who reads it.
bool asks_for_reader(const std::string& file) {
  const std::string text = whole_file(file);
  for (const char* macro : {"SYNTHESIS", "YOSYS", "VERILATOR"})
    if (text.find(macro) != std::string::npos) return true;
  return false;
}

bool is_of_project(const std::string& file) {
  for (const std::string& folder : rtl_folders())
    if (fs::path(file).parent_path() == fs::absolute(folder).lexically_normal()) return true;
  return false;
}

/// What yosys says; nothing if it does not read the RTL.
std::optional<std::string> netlist_json(const RtlSources& rtl) {
  const WorkFolder work;
  const std::string out = work.file("paths.json");
  std::vector<std::string> words = {recipe_file(), "--paths",
                                    rtl.top + "=" + fs::absolute(rtl.files.front()).string(), out};
  for (std::string setting : rtl.parameters) {
    setting.erase(std::remove(setting.begin(), setting.end(), '"'), setting.end());
    words.push_back(setting);
  }
  ToolResult result{};
  run_tools({{words, work.path(), {"TMPDIR=" + work.path()}, {}}}, 1, Limit,
            [&result](std::size_t, const ToolResult& end) { result = end; });
  if (!result.good || !fs::exists(out)) return {};
  return whole_file(out);
}

constexpr const char* Unknown = "?";

void write_groups(const RtlSources& rtl, const std::string& clock, const std::string& out) {
  std::ofstream file(out);
  file << "ports of " << rtl.top << " and their groups\n";
  const auto json = netlist_json(rtl);
  if (!json) file << Unknown << '\n';
  else try {
      for (const auto& [name, group] : comb_groups_in(*json, clock))
        file << name << ' ' << group << '\n';
    } catch (const RtlError&) {
      file << Unknown << '\n';
    }
  file.close();
  if (!file) throw RtlError("cannot write " + out + "; is the disk full?");
}

}  // namespace

CombGroups one_group(const RtlSyntax& syntax) {
  CombGroups all;
  for (const RtlSyntax::Port& port : syntax.ports)
    if (port.name != syntax.clock) all[port.name] = 0;
  return all;
}

const std::string& JoinedNames::first_of(const std::string& name) const {
  auto at = above_.find(name);
  while (at->second != at->first) at = above_.find(at->second);
  return at->first;
}

void JoinedNames::join(const std::string& a, const std::string& b) {
  for (const std::string& name : {a, b}) above_.emplace(name, name);
  above_.at(first_of(a)) = first_of(b);
}

CombGroups JoinedNames::groups() const {
  CombGroups all;
  std::map<std::string, int> numbers;
  for (const auto& [name, above] : above_)
    all[name] = numbers.emplace(first_of(name), static_cast<int>(numbers.size())).first->second;
  return all;
}

CombGroups comb_groups_in(const std::string& json, const std::string& clock) {
  JoinedNames joined;
  try {
    const Json all = Json::parse(json);
    const Json& module = all.at("modules").begin().value();
    const auto moved = moved_by(module.at("cells"));
    std::map<int, std::string> outputs;
    for (const auto& port : module.at("ports").items())
      if (port.value().at("direction") != "input")
        for (const int net : nets_of(port.value().at("bits"))) {
          const auto [other, is_new] = outputs.emplace(net, port.key());
          if (!is_new) joined.join(other->second, port.key());
        }
    for (const auto& port : module.at("ports").items())
      if (port.value().at("direction") == "input" && port.key() != clock)
        for (const int net : moved_from(nets_of(port.value().at("bits")), moved))
          if (const auto out = outputs.find(net); out != outputs.end())
            joined.join(port.key(), out->second);
  } catch (const Json::exception& error) {
    throw RtlError(std::string("this is no netlist of yosys: ") + error.what());
  }
  return joined.groups();
}

CombGroups comb_groups(const RtlSources& sources) {
  const RtlSyntax syntax = read_rtl_syntax(sources);
  const bool one_file = sources.files.size() == 1 && sources.defines.empty() &&
                        sources.include_folders.empty() && sources.libraries.empty();
  if (!one_file || sources.kind != RtlSources::Unit || !has_tool("yosys")) return one_group(syntax);
  std::vector<std::string> parts = {Recipe, sources.top, yosys_version(), file_key(recipe_file())};
  for (const std::string& file : syntax.files) {
    if (!is_of_project(file) && asks_for_reader(file)) return one_group(syntax);
    parts.push_back(file_key(file));
  }
  for (const std::string& setting : sources.parameters) parts.push_back(setting);
  const std::string names = cached(content_key(parts) + ".groups", [&](const std::string& out) {
    write_groups(sources, syntax.clock, out);
  });
  std::ifstream in(names);
  std::string line, name;
  std::getline(in, line);  // what they are
  CombGroups groups;
  for (int group = 0; in >> name && name != Unknown && in >> group;) groups[name] = group;
  if (name == Unknown) return one_group(syntax);
  return groups;
}

}  // namespace racebeam
