// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/gate_netlist.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/nearest.h"
#include "tb/base/whole_file.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/making_line.h"
#include "tb/verilate/rtl_syntax.h"
#include "tb/verilate/run_tool.h"
#include "tb/verilate/simulated_cells.h"
#include "tb/verilate/yosys.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr const char* Word = "gates";
constexpr auto Limit = std::chrono::minutes(30);  // for yosys

/// Not .v: the folders of files that Verilator reads are searched for modules.
constexpr const char* Extension = ".gates";

/// `Name="table.hex"` as the script takes it: Name=table.hex.
std::string unquoted(std::string setting) {
  setting.erase(std::remove(setting.begin(), setting.end(), '"'), setting.end());
  return setting;
}

/// All that a netlist depends on.
std::string key_of(const RtlSources& rtl, const std::string& kind) {
  std::vector<std::string> parts = {kind, rtl.top, yosys_version(), file_key(recipe_file())};
  if (kind == Osu018Gates) parts.push_back(file_key(osu018_cells()));
  for (const std::string& setting : rtl.parameters) {
    parts.push_back(setting.substr(0, setting.find('=')));
    const std::string value = unquoted(setting.substr(setting.find('=') + 1));
    parts.push_back(fs::is_regular_file(value) ? file_key(value) : value);
  }
  for (const std::string& file : read_rtl_syntax(rtl).files) {
    parts.push_back(fs::path(file).filename());
    parts.push_back(file_key(file));
    if (fs::exists(fs::path(file).replace_extension(".sdc"))) parts.emplace_back("stays a module");
  }
  return content_key(parts);
}

/// Before the netlist, as the script says it: "// stacks 86 506 18404".
constexpr const char* Figures = "// ";

/// What the script says.
std::string run_recipe(const RtlSources& rtl, std::vector<std::string> words,
                       const std::string& what) {
  const MakingLine line("making " + what);
  const WorkFolder work;
  words.insert(words.begin(), recipe_file());
  ToolResult result{};
  run_tools({{words, work.path(), {"TMPDIR=" + work.path()}, line.tick()}}, 1, Limit,
            [&result](std::size_t, const ToolResult& end) { result = end; });
  if (result.late)
    throw RtlError("yosys has not made " + what + " within " + std::to_string(Limit.count()) +
                   " minutes");
  if (!result.good) throw RtlError(rtl.files.front() + " does not become gates:\n" + result.said);
  return result.said;
}

void make(const RtlSources& rtl, const std::string& kind, const std::string& out) {
  const WorkFolder work;
  const std::string netlist = work.file("netlist.v");
  std::vector<std::string> words = {kind == Osu018Gates ? "--osu018" : "--gates",
                                    rtl.top + "=" + fs::absolute(rtl.files.front()).string(),
                                    netlist};
  for (const std::string& setting : rtl.parameters) words.push_back(unquoted(setting));
  const std::string said =
      run_recipe(rtl, std::move(words), "gates of " + rtl.top + " (" + kind + ")");
  std::ofstream whole(out);
  whole << Figures << said.substr(0, said.find('\n')) << '\n' << whole_file(netlist);
  whole.close();
  if (!whole) throw RtlError("cannot write " + out + "; is the disk full?");
}

/// Their text in a file of the cache that is named after it.
std::string text_file(const std::string& top, const std::string& kind, const std::string& text) {
  return cached(top + "-" + kind + "-" + content_key({text}) + Extension,
                [&text](const std::string& out) {
                  std::ofstream file(out);
                  file << text;
                  file.close();
                  if (!file) throw RtlError("cannot write " + out + "; is the disk full?");
                });
}

}  // namespace

const std::vector<std::string>& gate_kinds() {
  static const std::vector<std::string> kinds = {GenericGates, Osu018Gates};
  return kinds;
}

std::optional<GateWord> gate_word(const std::string& text) {
  const std::string word = Word;
  if (text == word) return GateWord{GenericGates, ""};
  if (text.rfind(word + ":", 0) != 0) return {};
  const std::string rest = text.substr(word.size() + 1), kind = rest.substr(0, rest.find(':'));
  const bool known = std::count(gate_kinds().begin(), gate_kinds().end(), kind) != 0;
  const std::string file = !known                       ? rest
                           : kind.size() == rest.size() ? ""
                                                        : rest.substr(kind.size() + 1);
  std::error_code error;
  const fs::path extension = fs::path(file).extension();
  const bool rtl = extension == ".sv" || extension == ".v";
  if (rtl && !fs::is_regular_file(file, error))
    throw UsageError("there is no file '" + file + "' to be made into gates");
  if (rtl || (known && kind.size() == rest.size()))
    return GateWord{known ? kind : GenericGates, file};
  std::vector<std::string> all = gate_kinds();
  all.emplace_back("FILE.sv");
  all.emplace_back("osu018:FILE.sv");
  throw unknown_name("gates", rest, all);
}

GateNetlist gate_netlist(const RtlSources& rtl, const std::string& kind) {
  GateNetlist netlist;
  netlist.file = cached(rtl.top + "-" + kind + "-" + key_of(rtl, kind) + Extension,
                        [&](const std::string& out) { make(rtl, kind, out); });
  if (kind != Osu018Gates) return netlist;
  std::ifstream in(netlist.file);
  std::string comment, name;
  if (!(in >> comment >> name >> netlist.flip_flops >> netlist.cells >> netlist.area))
    throw RtlError(netlist.file + " has no figures; delete it");
  return netlist;
}

std::string gate_bits(const RtlSources& rtl) {
  const std::string netlist = gate_netlist(rtl, GenericGates).file;
  const std::string key =
      content_key({yosys_version(), file_key(recipe_file()), file_key(netlist), "bits"});
  return cached(rtl.top + "-" + key + ".blif", [&](const std::string& out) {
    run_recipe(rtl, {"--bits", rtl.top + "=" + netlist, out}, "bits of the gates of " + rtl.top);
  });
}

RtlSources simulated_gates(const RtlSources& rtl, const std::string& kind, bool signals) {
  const RtlSyntax syntax = read_rtl_syntax(rtl);
  RtlSources gates{rtl.top};
  for (const RtlSyntax::Parameter& parameter : syntax.parameters)
    if (!parameter.value.empty()) gates.made_with.push_back(parameter.name + "=" + parameter.value);
  gates.signals = gates.marked_only = signals;
  const std::string netlist = gate_netlist(rtl, kind).file;
  if (kind != Osu018Gates && !signals) {
    gates.files = {netlist};
    return gates;
  }
  std::string text = whole_file(netlist);
  if (signals) text = with_marked_registers(text);
  if (kind == Osu018Gates) text = behind_whole_ports(text, syntax) + osu018_functions();
  gates.files = {text_file(rtl.top, kind, text)};
  return gates;
}

}  // namespace racebeam
