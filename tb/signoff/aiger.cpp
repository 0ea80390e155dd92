// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/aiger.h"

#include <algorithm>
#include <sstream>

#include "sc/swap/rtl_library.h"

namespace racebeam {

namespace {

constexpr unsigned More = 0x80, Digit = 0x7f;  // of a number in a file
constexpr int DigitBits = 7;

[[noreturn]] void refuse() { throw RtlError("yosys has written no AIGER file"); }

class Reader {
 public:
  explicit Reader(const std::string& text) : text_(text) {}
  std::string line() {
    const auto end = text_.find('\n', at_);
    if (end == std::string::npos) refuse();
    std::string line = text_.substr(at_, end - at_);
    at_ = end + 1;
    return line;
  }
  Literal literal() {
    std::istringstream words(line());
    Literal literal;
    if (!(words >> literal)) refuse();
    // What a register begins with.
    if (std::string more; words >> more && more != "0") refuse();
    return literal;
  }
  Literal number() {
    Literal value = 0;
    for (int shift = 0;; shift += DigitBits) {
      if (at_ == text_.size() || shift > 28) refuse();
      const unsigned byte = static_cast<unsigned char>(text_[at_++]);
      value |= (byte & Digit) << shift;
      if ((byte & More) == 0) return value;
    }
  }

 private:
  const std::string& text_;
  std::size_t at_ = 0;
};

void write_number(std::string& out, Literal value) {
  for (; value > Digit; value >>= DigitBits) out += static_cast<char>((value & Digit) | More);
  out += static_cast<char>(value);
}

}  // namespace

Literal AndCircuit::all(Literal a, Literal b) {
  if (a == False || b == False || a == (b ^ 1)) return False;
  if (a == True || a == b) return b;
  if (b == True) return a;
  gates.push_back({a, b});
  return register_at(next.size() + gates.size() - 1);
}

std::vector<Literal> AndCircuit::copy(const AndCircuit& circuit,
                                      const std::vector<Literal>& values) {
  std::vector<Literal> known{False};  // by variable
  known.insert(known.end(), values.begin(), values.end());
  const auto here = [&known](Literal literal) { return known[literal / 2] ^ (literal & 1); };
  for (const auto& [a, b] : circuit.gates) known.push_back(all(here(a), here(b)));
  std::vector<Literal> copied;
  for (const Literal output : circuit.outputs) copied.push_back(here(output));
  return copied;
}

AndCircuit read_circuit(const std::string& aiger) {
  Reader in(aiger);
  std::string kind;
  std::size_t variables, registers, outputs, gates, assertions = 0, others = 0;
  AndCircuit circuit;
  std::istringstream head(in.line());
  if (!(head >> kind >> variables >> circuit.inputs >> registers >> outputs >> gates) ||
      kind != "aig")
    refuse();
  head >> assertions;
  while (head >> others)
    if (others != 0) refuse();
  for (std::size_t n = 0; n < registers; ++n) circuit.next.push_back(in.literal());
  for (std::size_t n = 0; n < outputs; ++n) circuit.outputs.push_back(in.literal());
  for (std::size_t n = 0; n < assertions; ++n) circuit.failing.push_back(in.literal());
  for (std::size_t n = 0; n < gates; ++n) {
    const Literal gate = circuit.register_at(registers + n);
    const Literal left = gate - in.number(), right = left - in.number();
    if (left >= gate || right > left) refuse();
    circuit.gates.push_back({left, right});
  }
  return circuit;
}

std::string aiger_of(const AndCircuit& circuit) {
  const std::size_t registers = circuit.next.size(), gates = circuit.gates.size();
  std::string out = "aig";
  for (const std::size_t count : {circuit.inputs + registers + gates, circuit.inputs, registers,
                                  circuit.outputs.size(), gates})
    out += " " + std::to_string(count);
  out += "\n";
  for (const auto* literals : {&circuit.next, &circuit.outputs})
    for (const Literal literal : *literals) out += std::to_string(literal) + "\n";
  for (std::size_t n = 0; n < gates; ++n) {
    const auto [least, most] = std::minmax(circuit.gates[n][0], circuit.gates[n][1]);
    write_number(out, circuit.register_at(registers + n) - most);
    write_number(out, most - least);
  }
  return out;
}

AndCircuit with_constant_inputs(AndCircuit circuit, const std::map<std::size_t, bool>& constants) {
  const auto tie = [&](Literal& literal) {
    const std::size_t variable = literal / 2;
    if (variable == 0 || variable > circuit.inputs) return;
    const auto constant = constants.find(variable - 1);
    if (constant != constants.end())
      literal = static_cast<Literal>(constant->second) ^ (literal & 1);
  };
  for (auto* literals : {&circuit.next, &circuit.outputs, &circuit.failing})
    for (Literal& literal : *literals) tie(literal);
  for (auto& gate : circuit.gates)
    for (Literal& side : gate) tie(side);
  return circuit;
}

// Variables keep their numbers: registers come behind the inputs already.
AndCircuit without_registers(AndCircuit circuit) {
  circuit.inputs += circuit.next.size();
  circuit.outputs.insert(circuit.outputs.begin(), circuit.next.begin(), circuit.next.end());
  circuit.next.clear();
  return circuit;
}

AndCircuit cone_of(const AndCircuit& circuit, const std::vector<Literal>& outputs) {
  const std::size_t first = 1 + circuit.inputs;
  std::vector<bool> needed(first + circuit.gates.size());
  for (const Literal output : outputs) needed[output / 2] = true;
  for (std::size_t n = needed.size(); n-- > first;)
    if (needed[n])
      for (const Literal read : circuit.gates[n - first]) needed[read / 2] = true;
  AndCircuit cone;
  cone.inputs = circuit.inputs;
  std::vector<Literal> known(needed.size());
  const auto here = [&known](Literal literal) { return known[literal / 2] ^ (literal & 1); };
  for (std::size_t n = 1; n < needed.size(); ++n) {
    if (n < first) known[n] = cone.input(n - 1);
    else if (needed[n])
      known[n] = cone.all(here(circuit.gates[n - first][0]), here(circuit.gates[n - first][1]));
  }
  for (const Literal output : outputs) cone.outputs.push_back(here(output));
  return cone;
}

CircuitLanes::CircuitLanes(const AndCircuit& circuit)
    : circuit_(circuit), values_(1 + circuit.inputs + circuit.next.size() + circuit.gates.size()) {}

void CircuitLanes::settle() {
  const std::size_t first = values_.size() - circuit_.gates.size();
  for (std::size_t n = 0; n < circuit_.gates.size(); ++n)
    values_[first + n] = of(circuit_.gates[n][0]) & of(circuit_.gates[n][1]);
}

void CircuitLanes::clock() {
  std::vector<std::uint64_t> next;
  for (const Literal literal : circuit_.next) next.push_back(of(literal));
  std::copy(next.begin(), next.end(), &register_at(0));
}

}  // namespace racebeam
