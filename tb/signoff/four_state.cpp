// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/four_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/project_folder.h"
#include "tb/base/text_pattern.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/run_tool.h"

namespace racebeam {

namespace {

std::string read_text(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string run_or_throw(const WorkFolder& work, const std::vector<std::string>& words,
                         const std::string& what) {
  const ToolResult result = run_tool({words, work.path(), {}, {}});
  if (!result.good) throw RtlError(what + ":\n" + result.said);
  return result.said;
}

/// "Name=value" as scripts/netlist takes it.
std::vector<std::string> settings_of(const rtl_model& model) {
  std::vector<std::string> settings;
  std::istringstream words(model.parameters);
  for (std::string word; words >> word;) {
    word.erase(std::remove(word.begin(), word.end(), '"'), word.end());
    if (word.back() != '=') settings.push_back(word);
  }
  return settings;
}

void make_netlist(const WorkFolder& work, const rtl_model& model) {
  const std::string place = rtl_place(model);
  std::vector<std::string> words = {
      project_folder() + "/scripts/netlist",
      std::string(model.unit) + "=" + place.substr(0, place.rfind(':')), work.file("netlist.v")};
  for (const std::string& setting : settings_of(model)) words.push_back(setting);
  run_or_throw(work, words, "yosys makes no netlist of " + std::string(model.unit));
}

/// Without the number of an element; those of generate blocks stay.
std::string stem_of(std::string name) {
  while (!name.empty() && name.back() == ']') name.erase(name.rfind('['));
  return name;
}

/// The declared registers and memories of the netlist by the names of the source: "tags_q".
struct NetRegister {
  std::string module, declared, stem;  // the module without what yosys says of its parameters
  int elements;                        ///< of a memory; 0: none
};
TextPattern::Groups declaration(const std::string& line) {
  static const TextPattern Declared(
      "^ *reg (\\[[0-9:]*\\] )?(\\\\?[^ ;]+) ?(\\[([0-9]+):([0-9]+)\\])?( *=.*)?;");
  return Declared.search(line);
}
std::vector<NetRegister> registers_of(const std::string& netlist) {
  static const TextPattern Module("^module (\\\\\\$paramod(\\$[0-9a-f]+)?\\\\)?([A-Za-z0-9_]+)");
  std::vector<NetRegister> all;
  std::istringstream lines(netlist);
  std::string module;
  for (std::string line; std::getline(lines, line);) {
    if (const TextPattern::Groups head = Module.search(line); !head.empty()) module = head[3];
    const TextPattern::Groups found = declaration(line);
    if (found.empty()) continue;
    std::string stem = found[2];
    if (stem[0] == '\\') stem.erase(0, 1);
    int elements = 0;
    if (!found[4].empty()) elements = 1 + std::max(std::stoi(found[4]), std::stoi(found[5]));
    all.push_back({module, found[2], stem_of(stem), elements});
  }
  return all;
}

/// The inputs of a clock as one binary number, the first input in the upper bits.
std::string row_bits(const PortTraffic& traffic, std::uint64_t clock) {
  std::string bits;
  for (std::size_t n = 0; n < traffic.ports.size(); ++n) {
    if (!traffic.ports[n].input) continue;
    for (int bit = traffic.ports[n].bits - 1; bit >= 0; --bit)
      bits += (traffic.row(clock)[n] >> bit & 1) != 0 ? '1' : '0';
  }
  return bits.empty() ? "0" : bits;
}

constexpr int AfterReset = 2;  // when the first clock has risen and fallen

bool is_instance(const std::string& name) { return name.rfind("u_", 0) == 0; }

/// The module whose register a path names, and the register: "u_lane.sum_q" is of a lane, "idx2_q"
/// of the unit itself.
struct RegisterPath {
  std::string module, name;

  RegisterPath(std::string path, const std::string& unit) : module(unit) {
    const auto dot = path.rfind('.');
    name = path.substr(dot + 1);
    if (dot == std::string::npos) return;
    path.erase(dot);
    const std::string instance = stem_of(path.substr(path.rfind('.') + 1));
    if (is_instance(instance)) module = instance.substr(2);
  }
};

/// `known`: as a path, or an instance that names its module.
bool is_known(const NetRegister& one, const std::string& unit, const std::string& known) {
  const RegisterPath path(known, unit);
  if (is_instance(path.name)) return one.module == path.name.substr(2);
  return one.module == path.module && one.stem == path.name;
}

/// What a register is given after the clock in reset; empty: nothing. Of one that yosys has split
/// each part, "\\pwm_q[9:0]", gets its bits.
std::string opened(const NetRegister& one, const std::string& unit,
                   const std::vector<OpenRegister>& open) {
  static const TextPattern Part("\\[([0-9]+)(:([0-9]+))?\\]$");
  const std::string declared = one.declared.substr(one.declared[0] == '\\' ? 1 : 0);
  const auto give = [&](std::uint64_t value) {
    return fmt::format(" #{} {} = 64'd{};", AfterReset, one.declared, value);
  };
  for (const OpenRegister& wanted : open) {
    const RegisterPath path(wanted.name, unit);
    if (one.module != path.module) continue;
    if (declared == path.name) return give(wanted.value);
    const TextPattern::Groups part = Part.search(declared);
    if (one.stem != path.name || part.empty()) continue;
    const int high = std::stoi(part[1]), low = part[3].empty() ? high : std::stoi(part[3]);
    return give(wanted.value >> low & ((std::uint64_t{2} << (high - low)) - 1));
  }
  return "";
}

/// The netlist with those registers 0 at power-up.
std::string with_zeros(const std::string& netlist, const std::vector<NetRegister>& registers,
                       const std::string& unit, const std::vector<std::string>& known,
                       const std::vector<OpenRegister>& open) {
  std::string text;
  std::istringstream lines(netlist);
  auto next = registers.begin();
  for (std::string line; std::getline(lines, line);) {
    text += line + "\n";
    if (next == registers.end() || declaration(line).empty()) continue;
    const NetRegister& one = *next++;
    if (std::none_of(known.begin(), known.end(),
                     [&](const std::string& name) { return is_known(one, unit, name); }))
      continue;
    if (one.elements == 0)
      text += fmt::format("  initial begin {} = 0;{} end\n", one.declared, opened(one, unit, open));
    for (int n = 0; n < one.elements; ++n)
      text += fmt::format("  initial {} [{}] = 0;\n", one.declared, n);
  }
  return text;
}

std::string bench_text(const PortTraffic& traffic, bool has_clock) {
  std::string declared, pins, inputs, looks;
  int bits = 0;
  if (has_clock) pins = ".clk_i(clk)";
  for (const PortTraffic::Port& port : traffic.ports) {
    declared +=
        fmt::format("  {} [{}:0] {};\n", port.input ? "reg" : "wire", port.bits - 1, port.name);
    pins += fmt::format("{}.{}({})", pins.empty() ? "" : ", ", port.name, port.name);
    if (port.input) {
      inputs += (inputs.empty() ? "" : ", ") + port.name;
      bits += port.bits;
    } else {
      declared += "  reg seen_" + port.name + " = 0;\n";
      looks += fmt::format(
          "      if (n > 0 && !seen_{0} && ^{0} === 1'bx) begin\n"
          "        $display(\"unknown {0} %0d\", n); seen_{0} = 1;\n      end\n",
          port.name);
    }
  }
  return fmt::format(
      "module bench;\n  reg clk = 0;\n{0}  reg [{1}:0] stimulus [0:{2}];\n  integer n;\n"
      "  {3} dut ({4});\n  initial begin\n    $readmemb(\"stimulus\", stimulus);\n"
      "    for (n = 0; n <= {2}; n = n + 1) begin\n      {{{5}}} = stimulus[n]; #1;\n"
      "      if (n == 1) begin\n        $dumpfile(\"reset.vcd\"); $dumpvars(0, dut); #1;"
      " $dumpoff;\n      end\n{6}      clk = 1; #1; clk = 0; #1;\n    end\n    $finish;\n  end\n"
      "endmodule\n",
      declared, std::max(bits - 1, 0), traffic.clocks() - 1, traffic.unit, pins, inputs, looks);
}

/// The stems of registers that have an x among their first values.
std::vector<std::string> unknown_registers(const std::string& vcd,
                                           const std::vector<NetRegister>& registers) {
  static const TextPattern Variable("^\\$var +reg +[0-9]+ +([^ ]+) +([^ ]+)");
  std::set<std::string> stems, found;
  for (const NetRegister& one : registers) stems.insert(one.stem);
  std::vector<std::pair<std::string, std::string>> named;  // code, stem
  std::istringstream lines(vcd);
  bool first = false;
  for (std::string line; std::getline(lines, line);) {
    if (const TextPattern::Groups var = Variable.search(line); !var.empty()) {
      std::string stem = var[2];
      if (stem[0] == '\\') stem.erase(0, 1);
      stem = stem_of(stem);
      if (stems.count(stem) != 0) named.emplace_back(var[1], stem);
    }
    if (line.rfind("$dumpvars", 0) == 0) first = true;
    if (line.rfind("$end", 0) == 0) first = false;
    if (!first || line.find('x') == std::string::npos) continue;
    const auto space = line.find(' ');
    const bool unknown = space == std::string::npos
                             ? line[0] == 'x'
                             : line.substr(0, space).find('x') != std::string::npos;
    const std::string code = space == std::string::npos ? line.substr(1) : line.substr(space + 1);
    for (const auto& [its, stem] : named)
      if (unknown && its == code) found.insert(stem);
  }
  return {found.begin(), found.end()};
}

}  // namespace

FourStateFindings run_in_four_states(const std::string& plugin, const PortTraffic& traffic,
                                     const std::vector<std::string>& known,
                                     const std::vector<OpenRegister>& open) {
  for (const char* tool : {"yosys", "iverilog"})
    if (!has_tool(tool))
      throw MissingTool(std::string(tool) + " is not installed; install the package `" + tool +
                        "`");
  const rtl_library rtl(plugin);
  const WorkFolder work;
  make_netlist(work, rtl.model());
  const std::string netlist = read_text(work.file("netlist.v"));
  const auto registers = registers_of(netlist);
  work.write("netlist.v", with_zeros(netlist, registers, traffic.unit, known, open));
  work.write("bench.v", bench_text(traffic, has_rtl_port(rtl.model(), "clk_i")));
  std::string rows;
  for (std::uint64_t clock = 0; clock < traffic.clocks(); ++clock)
    rows += row_bits(traffic, clock) + "\n";
  work.write("stimulus", rows);
  run_or_throw(work, {"iverilog", "-g2005", "-o", "bench", "bench.v", "netlist.v"},
               "Icarus does not compile the netlist of " + traffic.unit);
  const std::string said = run_or_throw(work, {"vvp", "-n", "bench"},
                                        "Icarus does not run the netlist of " + traffic.unit);
  FourStateFindings findings;
  std::istringstream words(said);
  for (std::string word; words >> word;) {
    if (word != "unknown") continue;
    FourStateFindings::Pin pin{};
    words >> pin.port >> pin.clock;
    findings.pins.push_back(pin);
  }
  findings.registers = unknown_registers(read_text(work.file("reset.vcd")), registers);
  return findings;
}

}  // namespace racebeam
