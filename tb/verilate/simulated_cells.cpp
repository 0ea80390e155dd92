// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/simulated_cells.h"

#include <sstream>

#include "sc/swap/rtl_library.h"
#include "tb/base/text_pattern.h"
#include "tb/base/whole_file.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/run_tool.h"
#include "tb/verilate/yosys.h"

namespace racebeam {

namespace {

constexpr const char* Cells = "_cells";  ///< after the name of the module within

}  // namespace

std::string with_marked_registers(const std::string& netlist) {
  static const TextPattern Declaration(
      "  (?:input|output|wire|reg) (?:\\[[-0-9:]+\\] )?(?:[A-Za-z]|\\\\[^_ ])[^ ,;]* ?;");
  std::istringstream lines(netlist);
  std::string marked;
  for (std::string line; std::getline(lines, line);) {
    if (Declaration.matches(line)) line.insert(line.size() - 1, " /*verilator public_flat_rw*/ ");
    marked += line + "\n";
  }
  return marked;
}

std::string behind_whole_ports(const std::string& netlist, const RtlSyntax& syntax) {
  const std::string module = "module " + syntax.top.name, within = syntax.top.name + Cells;
  const auto at = netlist.find(module + "(");
  if (at == std::string::npos) throw RtlError("the gates have no " + module);
  std::string ports, pins;
  for (const RtlSyntax::Port& port : syntax.ports) {
    ports += (ports.empty() ? "\n  " : ",\n  ") + port.direction + " wire " +
             (port.bits > 1 ? "[" + std::to_string(port.bits - 1) + ":0] " : "") + port.name;
    for (int bit = 0; bit < port.bits; ++bit) {
      const std::string index = "[" + std::to_string(bit) + "]";
      pins += pins.empty() ? "\n    " : ",\n    ";
      pins += port.bits > 1 ? ".\\" + port.name + index + " (" + port.name + index + ")"
                            : "." + port.name + "(" + port.name + ")";
    }
  }
  return std::string(netlist).replace(at, module.size(), "module " + within) + "\n" + module +
         " (" + ports + "\n);\n  " + within + " u_cells (" + pins + "\n  );\nendmodule\n";
}

std::string osu018_functions() {
  const std::string library = osu018_cells();
  const std::string key = content_key({yosys_version(), file_key(library), "1"});
  return whole_file(cached("osu018-" + key + ".gates", [&](const std::string& out) {
    const ToolResult result = run_tool(
        {{"yosys", "-q", "-p", "read_liberty " + library + "; write_verilog -noattr " + out},
         "",
         {},
         {}});
    if (!result.good) throw RtlError(library + " is none that yosys reads:\n" + result.said);
  }));
}

}  // namespace racebeam
