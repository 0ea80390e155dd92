// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutant_circuits.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <random>
#include <sstream>
#include <utility>

#include "sc/base/fixed_point.h"
#include "sc/base/unit.h"
#include "tb/base/reset_value.h"
#include "tb/base/whole_file.h"
#include "tb/signoff/aiger.h"
#include "tb/signoff/memory_bits.h"
#include "tb/signoff/memory_cut.h"
#include "tb/signoff/yosys_sources.h"
#include "tb/verilate/cache_folder.h"

namespace racebeam {

namespace {

constexpr int Enumerated = 16;  // bits of an input whose values are all looked at
constexpr int Samples = 4096;   // of wider ones
constexpr const char* Miter = "racebeam_miter";
constexpr const char* Step = "racebeam_step";
constexpr const char* Unit = "racebeam_unit";
constexpr std::size_t MostMemory = 16'384;  // bits that are written and looked at
constexpr const char* Memory = "memory -nordff\n";
constexpr const char* Lowering =
    "opt -fast\npmuxtree\ndffunmap\ntechmap\nopt -fast -nodffe -nosdff\n"
    "setundef -undriven -init -zero\naigmap\nopt_clean\n";

using Raw = std::uint64_t;

Raw formed(const LegalInputs& legal, const PortTraffic::Port& port, Raw raw) {
  return raw_bits(legal.legal(port.name, raw_bits(raw, port.bits)), port.bits);
}

/// Ranges of the values that rules make.
std::string enumerated(const LegalInputs& legal, const PortTraffic::Port& port) {
  std::vector<bool> made(std::size_t{1} << port.bits);
  for (Raw raw = 0; raw < made.size(); ++raw)
    made[static_cast<std::size_t>(formed(legal, port, raw))] = true;
  std::string text;
  for (std::size_t from = 0; from < made.size(); ++from) {
    if (!made[from]) continue;
    std::size_t to = from;
    while (to + 1 < made.size() && made[to + 1]) ++to;
    if (from == 0 && to + 1 == made.size()) return "";
    text += fmt::format("{}({} >= {} && {} <= {})", text.empty() ? "" : " || ", port.name, from,
                        port.name, to);
    from = to;
  }
  return "(" + text + ")";
}

/// A number that is kept in fewer bits, signed or not.
std::string narrowed(const LegalInputs& legal, const PortTraffic::Port& port) {
  std::mt19937_64 random(1);
  std::vector<Raw> samples(Samples);
  for (Raw& sample : samples) sample = raw_bits(random(), port.bits);
  const auto all = [&](auto same) { return std::all_of(samples.begin(), samples.end(), same); };
  for (int bits = 1; bits < port.bits; ++bits) {
    if (all([&](Raw raw) { return formed(legal, port, raw) == raw_bits(raw, bits); }))
      return fmt::format("({}[{}:{}] == 0)", port.name, port.bits - 1, bits);
    if (all([&](Raw raw) {
          return formed(legal, port, raw) ==
                 raw_bits(static_cast<Raw>(signed_bits(raw, bits)), port.bits);
        }))
      return fmt::format("(&{0}[{1}:{2}] || ~|{0}[{1}:{2}])", port.name, port.bits - 1, bits - 1);
  }
  return "";
}

/// The condition that a value of an input is one that the chip can have, in Verilog; "" if all are.
/// Values of wide inputs whose rule is neither a narrower number nor a signed one are all allowed.
std::string legal_condition(const LegalInputs& legal, const PortTraffic::Port& port) {
  return port.bits <= Enumerated ? enumerated(legal, port) : narrowed(legal, port);
}

std::string clock_of(const std::string& rtlil) {
  for (const char* clock : {"clk_i", "clk"})
    if (rtlil.find(fmt::format(" \\{}\n", clock)) != std::string::npos) return clock;
  return "";
}

std::string range(int bits) { return bits > 1 ? fmt::format("[{}:0] ", bits - 1) : ""; }

std::string all_inputs(const ProofOfMutants& proof, int choice_bits) {
  std::string text = fmt::format("input clk, input {}{}", range(choice_bits), MutantInput);
  for (const PortTraffic::Port& port : proof.ports.ports)
    if (port.input) text += fmt::format(", input {}{}", range(port.bits), port.name);
  return text;
}

/// An instance of a module; `wire` names what a port is wired to.
template <class Wire>
std::string instance(const ProofOfMutants& proof, const std::string& module, bool chosen,
                     const Wire& wire) {
  std::string text = fmt::format("  {} u_{} (", module, module), comma;
  const std::string clock = clock_of(proof.netlist.rtlil);
  if (!clock.empty()) text += fmt::format(".{}(clk)", clock), comma = ", ";
  if (chosen) text += fmt::format("{0}.{1}({1})", comma, MutantInput), comma = ", ";
  for (const PortTraffic::Port& port : proof.ports.ports) {
    text += fmt::format("{}.{}({})", comma, port.name, wire(port));
    comma = ", ";
  }
  return text + ");\n";
}

/// Whether yosys-abc had too many registers to begin with all of them at 0.
bool has_large_memory(const ProofOfMutants& proof) {
  return written_bits(proof.netlist.rtlil) > MostMemory;
}

/// The mutants alone, or the unit; inputs that no chip has are replaced by one that it can have.
std::string step_module(const ProofOfMutants& proof, const char* name, bool mutants) {
  std::string outputs, wires;
  for (const PortTraffic::Port& port : proof.ports.ports) {
    if (!port.input) {
      outputs += fmt::format(", output {}{}", range(port.bits), port.name);
      continue;
    }
    const std::string condition = legal_condition(proof.legal, port);
    wires +=
        fmt::format("  wire {0}legal_{1} = {2} ? {1} : {3}'d{4};\n", range(port.bits), port.name,
                    condition.empty() ? "1" : condition, port.bits, formed(proof.legal, port, 0));
  }
  return fmt::format("module {} ({}{});\n", name,
                     all_inputs(proof, mutant_bits(proof.netlist.mutants)), outputs) +
         wires +
         instance(proof, "is_unit", mutants,
                  [](const PortTraffic::Port& port) {
                    return (port.input ? "legal_" : "") + port.name;
                  }) +
         "endmodule\n";
}

}  // namespace

std::string miter_module(const ProofOfMutants& proof, int choice_bits) {
  std::string resets, outputs, legal = "1", differ = "0";
  for (const PortTraffic::Port& port : proof.ports.ports) {
    if (!port.input) {
      outputs += fmt::format("  wire {0}was_{1}, is_{1};\n", range(port.bits), port.name);
      differ += fmt::format(" || was_{0} != is_{0}", port.name);
    } else if (const int value = reset_value(port.name); value >= 0) {
      resets += fmt::format("  wire after_{0} = started ? {0} : 1'b{1};\n", port.name, value);
    } else if (const std::string one = legal_condition(proof.legal, port); !one.empty()) {
      legal += " && " + one;
    }
  }
  const auto side = [&](const std::string& name, bool chosen) {
    return instance(proof, name + "_unit", chosen, [&name](const PortTraffic::Port& port) {
      if (!port.input) return name + "_" + port.name;
      return (reset_value(port.name) >= 0 ? "after_" : "") + port.name;
    });
  };
  return fmt::format(
             "module {} ({}, output differs);\n"
             "  reg started, kept;\n  initial started = 0;\n  initial kept = 1;\n"
             "  wire legal = {};\n"
             "  always @(posedge clk) begin\n    started <= 1;\n    kept <= kept && legal;\n"
             "  end\n",
             Miter, all_inputs(proof, choice_bits), legal) +
         resets + outputs + side("was", false) + side("is", true) +
         fmt::format("  assign differs = started && kept && legal && ({});\nendmodule\n", differ);
}

std::string circuit_commands(const ProofOfMutants& proof) {
  return std::string("flatten\n") + (has_large_memory(proof) ? MemoryCut : Memory) + Lowering;
}

std::string circuit_key(const ProofOfMutants& proof) {
  return content_key({proof.netlist.rtlil, miter_module(proof, 1),
                      circuit_commands(proof) + (has_large_memory(proof) ? WrittenMemory : "")});
}

MutantCircuits mutant_circuits(const ProofOfMutants& proof, const std::vector<Mutant>& mutants) {
  const WorkFolder work;
  work.write("plain.il", proof.netlist.rtlil);
  work.write("asserted.il", proof.netlist.asserted);
  work.write("miter.v", miter_module(proof, mutant_bits(proof.netlist.mutants)));
  work.write("step.v", step_module(proof, Step, true));
  work.write("unit.v", step_module(proof, Unit, false));
  work.write(WrittenFile, WrittenMemory);
  const std::string& unit = proof.ports.unit;
  const std::string mutated =
      fmt::format("read_rtlil plain.il\n{}rename {} is_unit\n",
                  choosing_commands(mutants, mutant_bits(proof.netlist.mutants)), unit);
  const auto written = [&proof](const char* top, const char* name) {
    return fmt::format(
        "read_verilog -sv {1}.v\nhierarchy -top {0}\nproc\n{2}"
        "write_aiger -zinit -map {1}.map {1}.aig\ndesign -reset\n",
        top, name, circuit_commands(proof));
  };
  const bool whole = !has_large_memory(proof);
  run_yosys((whole ? fmt::format("read_rtlil plain.il\nrename {} was_unit\n", unit) + mutated +
                         written(Miter, "miter")
                   : "") +
                mutated + written(Step, "step") +
                fmt::format("read_rtlil {}.il\nrename {} is_unit\n",
                            proof.netlist.asserted.empty() ? "plain" : "asserted", unit) +
                written(Unit, "unit"),
            work.path(), unit);
  const auto read = [&work](const std::string& name) { return whole_file(work.file(name)); };
  const auto circuit = [&read](const std::string& name) {
    return MutantCircuit(read(name + ".aig"), read(name + ".map"));
  };
  const MutantCircuit alone = circuit("unit"), step = circuit("step");
  return {whole ? std::optional(circuit("miter")) : std::nullopt, step,
          whole ? read("miter.map") : "", words_as_in(alone.named(), step.named()),
          claims_as_in(alone.named(), step.named())};
}

bool is_legal(const ProofOfMutants& proof, const std::vector<std::vector<Raw>>& rows) {
  for (const auto& row : rows) {
    std::size_t n = 0;
    for (const PortTraffic::Port& port : proof.ports.ports) {
      if (!port.input) continue;
      const Raw raw = row[n++];
      if (reset_value(port.name) < 0 && formed(proof.legal, port, raw) != raw) return false;
    }
  }
  return true;
}

}  // namespace racebeam
