// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutant_proof.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <random>
#include <sstream>

#include "sc/base/fixed_point.h"
#include "sc/base/unit.h"
#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/output_file.h"
#include "tb/base/reset_value.h"
#include "tb/base/whole_file.h"
#include "tb/signoff/aiger.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/run_tool.h"

namespace racebeam {

namespace {

constexpr int Enumerated = 16;  // bits of an input whose values are all looked at
constexpr int Samples = 4096;   // of wider ones
constexpr const char* Miter = "racebeam_miter";
// How a circuit is prepared. Where there are multipliers, scorr alone takes minutes, and a short
// search without it finds most differences; &scorr and lcorr merge most of the rest in seconds.
constexpr const char* AsItIs = "strash";
constexpr const char* Swept = "strash; &get; &scorr -C 10; &put; lcorr -C 100";
constexpr const char* SweptLong = "strash; scorr";
constexpr const char* Lowering =
    "flatten\nmemory\nopt -fast\npmuxtree\ndffunmap\ntechmap\nopt -fast -nodffe -nosdff\n"
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

std::string clock_of(const std::string& rtlil) {
  for (const char* clock : {"clk_i", "clk"})
    if (rtlil.find(fmt::format(" \\{}\n", clock)) != std::string::npos) return clock;
  return "";
}

std::string range(int bits) { return bits > 1 ? fmt::format("[{}:0] ", bits - 1) : ""; }

std::string miter_commands(const ProofOfMutants& proof, const std::vector<Mutant>& mutants) {
  return fmt::format(
      "read_rtlil plain.il\nrename {0} was_unit\nread_rtlil plain.il\n{1}rename {0} is_unit\n"
      "read_verilog -sv miter.v\nhierarchy -top {2}\nproc\n{3}"
      "write_aiger -zinit -map miter.map miter.aig\n",
      proof.ports.unit, choosing_commands(mutants, mutant_bits(proof.netlist.mutants)), Miter,
      Lowering);
}

/// Both in one module, whose output is 1 when they differ.
std::string miter_of(const ProofOfMutants& proof) {
  const std::string clock = clock_of(proof.netlist.rtlil);
  std::string resets, outputs, legal = "1", differ = "0";
  std::string inputs =
      fmt::format(", input {}{}", range(mutant_bits(proof.netlist.mutants)), MutantInput);
  for (const PortTraffic::Port& port : proof.ports.ports) {
    if (!port.input) {
      outputs += fmt::format("  wire {0}was_{1}, is_{1};\n", range(port.bits), port.name);
      differ += fmt::format(" || was_{0} != is_{0}", port.name);
      continue;
    }
    inputs += fmt::format(", input {}{}", range(port.bits), port.name);
    if (const int value = reset_value(port.name); value >= 0)
      resets += fmt::format("  wire after_{0} = started ? {0} : 1'b{1};\n", port.name, value);
    else if (const std::string one = legal_condition(proof.legal, port); !one.empty())
      legal += " && " + one;
  }
  const auto instance = [&](const std::string& module, const std::string& side) {
    std::string text = fmt::format("  {} u_{} (", module, side), comma;
    if (!clock.empty()) text += fmt::format(".{}(clk)", clock), comma = ", ";
    if (side == "is") text += fmt::format("{0}.{1}({1})", comma, MutantInput), comma = ", ";
    for (const PortTraffic::Port& port : proof.ports.ports) {
      const std::string wire = !port.input                   ? side + "_" + port.name
                               : reset_value(port.name) >= 0 ? "after_" + port.name
                                                             : port.name;
      text += fmt::format("{}.{}({})", comma, port.name, wire);
      comma = ", ";
    }
    return text + ");\n";
  };
  return fmt::format(
             "module {} (input clk{}, output differs);\n"
             "  reg started, kept;\n  initial started = 0;\n  initial kept = 1;\n"
             "  wire legal = {};\n"
             "  always @(posedge clk) begin\n    started <= 1;\n    kept <= kept && legal;\n"
             "  end\n",
             Miter, inputs, legal) +
         resets + outputs + instance("was_unit", "was") + instance("is_unit", "is") +
         fmt::format("  assign differs = started && kept && legal && ({});\nendmodule\n", differ);
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

}  // namespace

std::string legal_condition(const LegalInputs& legal, const PortTraffic::Port& port) {
  return port.bits <= Enumerated ? enumerated(legal, port) : narrowed(legal, port);
}

MutantProofs::MutantProofs(const ProofOfMutants& proof, const std::vector<int>& numbers)
    : proof_(proof), miter_(miter_of(proof)) {
  if (!has_tool("yosys-abc"))
    throw MissingTool("yosys-abc is not installed; it comes with the package yosys");
  std::vector<Mutant> mutants;
  for (const int number : numbers)
    if (in_cache(key_of(number)).empty())
      mutants.push_back(proof.netlist.mutants.at(static_cast<std::size_t>(number) - 1));
  if (mutants.empty() || proof.limit.count() == 0) return;
  const WorkFolder work;
  work.write("plain.il", proof.netlist.rtlil);
  work.write("miter.v", miter_);
  run_yosys(miter_commands(proof, mutants), work.path(), proof.ports.unit);
  circuit_ = whole_file(work.file("miter.aig"));
  read_map(whole_file(work.file("miter.map")));
}

// The text of a netlist tells yosys's version.
std::string MutantProofs::key_of(int number) const {
  const Mutant& mutant = proof_.netlist.mutants.at(static_cast<std::size_t>(number) - 1);
  return content_key({proof_.netlist.rtlil, mutant.command, miter_, Lowering}) + ".equal";
}

void MutantProofs::read_map(const std::string& text) {
  std::map<std::string, std::size_t> numbers;
  for (const PortTraffic::Port& port : proof_.ports.ports)
    if (port.input) numbers.emplace(port.name, numbers.size());
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind, name;
    std::size_t at;
    int bit;
    if (!(words >> kind >> at >> bit >> name) || kind != "input") continue;
    bits_.resize(std::max(bits_.size(), at + 1));
    if (const auto found = numbers.find(name); found != numbers.end())
      bits_[at] = {found->second, bit};
    if (name != MutantInput) continue;
    choice_.resize(std::max(choice_.size(), static_cast<std::size_t>(bit) + 1));
    choice_[static_cast<std::size_t>(bit)] = at;
  }
}

std::string MutantProofs::circuit_of(int number) const {
  std::map<std::size_t, bool> constants;
  for (std::size_t bit = 0; bit < choice_.size(); ++bit)
    constants[choice_[bit]] = ((number >> bit) & 1) != 0;
  return with_constant_inputs(circuit_, constants);
}

// As abc writes it: the registers, then a row of bits for each clock.
MutantProofs::Inputs MutantProofs::read_counterexample(const std::string& text) const {
  const auto& ports = proof_.ports.ports;
  const auto inputs = std::count_if(ports.begin(), ports.end(),
                                    [](const PortTraffic::Port& port) { return port.input; });
  Inputs rows;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    line = line.substr(0, line.find('#'));
    if (line.size() < bits_.size() || line.find_first_not_of("01x") != std::string::npos) continue;
    std::vector<std::uint64_t> row(static_cast<std::size_t>(inputs));
    for (std::size_t n = 0; n < bits_.size(); ++n)
      if (bits_[n].bit >= 0 && line[n] == '1') row[bits_[n].input] |= Raw{1} << bits_[n].bit;
    rows.push_back(row);
  }
  std::size_t n = 0;  // the first clock is in reset, whatever the inputs say
  if (!rows.empty())
    for (const PortTraffic::Port& port : ports) {
      if (!port.input) continue;
      if (const int value = reset_value(port.name); value >= 0)
        rows.front()[n] = static_cast<Raw>(value);
      ++n;
    }
  return rows;
}

MutantProof MutantProofs::prove(int number) const {
  if (!in_cache(key_of(number)).empty()) return {MutantProof::Equal, {}, ""};
  MutantProof proof = ask(number, {{AsItIs, "bmc3 -F 4", 0.1},
                                   {Swept, "pdr", 0.3},
                                   {SweptLong, "pdr", 0.4},
                                   {Swept, "bmc3 -F 1000", 0.2}});
  if (proof.verdict == MutantProof::Equal)
    cached(key_of(number), [&](const std::string& out) { write_text(out, "equal\n"); });
  return proof;
}

MutantProof MutantProofs::refute(int number) const {
  return ask(number, {{AsItIs, "bmc3 -F 4", 0.1}, {Swept, "bmc3 -F 1000", 0.9}});
}

MutantProof MutantProofs::ask(int number, const std::vector<Question>& questions) const {
  if (circuit_.empty()) return {MutantProof::Undecided, {}, "no proof was asked for"};
  const WorkFolder work;
  work.write("miter.aig", circuit_of(number));
  const double seconds = std::chrono::duration<double>(proof_.limit).count();
  std::string said;
  const auto says = [&](const char* status) { return said.find(status) != std::string::npos; };
  for (const Question& question : questions) {
    const int share = static_cast<int>(std::max(1.0, seconds * question.share));
    const ToolRun run{
        {"yosys-abc", "-q",
         fmt::format(
             "read_aiger miter.aig; {}; {} -T {}; print_status; write_cex -a counterexample",
             question.prepared, question.command, share)},
        work.path(),
        {},
        {}};
    run_tools({run}, 1, std::chrono::seconds(share + 1),
              [&](std::size_t, const ToolResult& end) { said = end.said; });
    if (says("Status = 1")) return {MutantProof::Equal, {}, ""};
    if (says("Status = 0")) break;
  }
  if (!says("Status = 0"))
    return {MutantProof::Undecided,
            {},
            fmt::format("yosys-abc neither proved it equal nor found a difference within {:g} "
                        "seconds",
                        seconds)};
  const Inputs rows = read_counterexample(whole_file(work.file("counterexample")));
  if (rows.empty()) throw RtlError("yosys-abc has written no counterexample:\n" + said);
  if (!is_legal(proof_, rows))
    return {MutantProof::Undecided, rows,
            "it differs on inputs only that a chip does not have, as far as yosys-abc can tell"};
  return {MutantProof::Counterexample, rows, ""};
}

}  // namespace racebeam
