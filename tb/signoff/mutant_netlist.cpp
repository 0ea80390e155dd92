// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutant_netlist.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/output_file.h"
#include "tb/base/whole_file.h"
#include "tb/signoff/yosys_sources.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/elaborated.h"
#include "tb/verilate/run_tool.h"

namespace racebeam {

namespace {

// Wires with several drivers have one bit: Verilator 5.006 gets a vector wrong whose bits depend on
// each other. So each output has a buffer.
//
// Of a multiplexer that a mistake lets choose two inputs one must be meant, the same as in proofs;
// Verilog of a $pmux has an assertion instead.
constexpr const char* Splitting =
    "pmuxtree; iopadmap -bits -outpad output_bit A:Y; splitnets -driver";
constexpr const char* OutputBit =
    "\nmodule output_bit(input A, output Y);\n  assign Y = A;\nendmodule\n";

std::string option(const std::string& line, const std::string& name) {
  std::istringstream words(line);
  for (std::string word, value; words >> word;)
    if (word == "-" + name && words >> value) return value;
  return "";
}

/// "inv $procmux$85 Y[5]", and for those that depend on another bit "cnot1 $procmux$85 Y[5] 1".
std::string name_of(const std::string& line) {
  const std::string ctrl = option(line, "ctrlbit");
  return fmt::format("{} {} {}[{}]{}", option(line, "mode"), option(line, "cell"),
                     option(line, "port"), option(line, "portbit"), ctrl.empty() ? "" : " " + ctrl);
}

std::string sources_of(const std::string& line) {
  std::istringstream words(line);
  std::string all;
  for (std::string word, value; words >> word;)
    if (word == "-src" && words >> value) all += (all.empty() ? "" : " ") + value;
  return all;
}

/// yosys has no memory whose words can be read at times only, if not by a clock.
bool is_possible(const std::string& line) {
  return option(line, "cell").find("$memrd$") == std::string::npos || option(line, "port") != "EN";
}

std::vector<Mutant> read_mutants(const std::string& list) {
  std::vector<Mutant> mutants;
  std::set<std::string> names;
  std::istringstream lines(list);
  for (std::string line; std::getline(lines, line);)
    if (line.rfind("mutate ", 0) == 0 && is_possible(line) && names.insert(name_of(line)).second)
      mutants.push_back(
          {static_cast<int>(mutants.size()) + 1, line, name_of(line), sources_of(line)});
  return mutants;
}

nlohmann::ordered_json to_json(const MutantNetlist& netlist) {
  nlohmann::ordered_json lines = nlohmann::ordered_json::array();
  for (const Mutant& mutant : netlist.mutants) lines.push_back(mutant.command);
  return {{"rtlil", netlist.rtlil},
          {"asserted", netlist.asserted},
          {"verilog", netlist.verilog},
          {"mutants", lines}};
}

MutantNetlist netlist_of(const nlohmann::ordered_json& json) {
  std::string lines;
  for (const auto& line : json.at("mutants")) lines += line.get<std::string>() + "\n";
  return {json.at("rtlil"), json.at("asserted"), json.at("verilog"), read_mutants(lines)};
}

// yosys 0.23 reads no assertion with an else; they only help proofs.
std::string asserted(const RtlSources& sources, const WorkFolder& work) try {
  run_yosys(reading_commands(sources, true) + "write_rtlil asserted.il\n", work.path(),
            sources.top);
  std::string text = whole_file(work.file("asserted.il"));
  return text.find("cell $assert") == std::string::npos ? "" : text;
} catch (const RtlError&) {
  return "";
}

// What a memory holds at the beginning is constant in yosys: a mistake cannot be chosen there.
MutantNetlist make(const RtlSources& sources, int most, unsigned seed) {
  const WorkFolder work;
  link_sources(sources, work.path());
  run_yosys(
      reading_commands(sources) + fmt::format("mutate -list {} -seed {} -o mutants t:$meminit* %n\n"
                                              "write_rtlil plain.il\n",
                                              most, seed),
      work.path(), sources.top);
  MutantNetlist netlist;
  netlist.mutants = read_mutants(whole_file(work.file("mutants")));
  netlist.rtlil = whole_file(work.file("plain.il"));
  netlist.asserted = asserted(sources, work);
  run_yosys("read_rtlil plain.il\n" +
                choosing_commands(netlist.mutants, mutant_bits(netlist.mutants)) + "opt_clean\n" +
                Splitting + "\nwrite_verilog -noattr mutants.v\n",
            work.path(), sources.top);
  netlist.verilog = whole_file(work.file("mutants.v")) + OutputBit;
  return netlist;
}

/// Which yosys it is: another one names cells in another way.
std::string yosys_version() { return run_tool({{"yosys", "-V"}, "", {}, {}}).said; }

}  // namespace

int mutant_bits(const std::vector<Mutant>& mutants) {
  int bits = 1;
  for (const Mutant& mutant : mutants)
    while ((mutant.number >> bits) != 0) ++bits;
  return bits;
}

std::string choosing_commands(const std::vector<Mutant>& mutants, int bits) {
  std::string text;
  for (const Mutant& mutant : mutants)
    text += fmt::format("mutate -ctrl {} {} {}{}\n", MutantInput, bits, mutant.number,
                        mutant.command.substr(std::string("mutate").size()));
  return text;
}

MutantNetlist mutant_netlist(const RtlSources& sources, int most, unsigned seed) {
  if (!has_tool("yosys")) throw MissingTool("yosys is not installed; scripts/setup installs it");
  const std::string key =
      content_key({elaborated(sources).content, fmt::format("{} {}", most, seed), yosys_version(),
                   reading_commands(sources, true), Splitting});
  const std::string path = cached(key + ".mutants", [&](const std::string& out) {
    write_text(out, to_json(make(sources, most, seed)).dump());
  });
  return netlist_of(nlohmann::ordered_json::parse(whole_file(path)));
}

}  // namespace racebeam
