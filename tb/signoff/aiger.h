// Circuits of AND gates and registers, in the binary format of AIGER as yosys writes it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace racebeam {

/// Twice the number of a variable, and one more if it is inverted; variable 0 is the constant 0.
using Literal = std::uint32_t;
constexpr Literal False = 0, True = 1;

/// Inputs are the variables from 1 on, then come registers, then gates.
struct AndCircuit {
  std::size_t inputs = 0;
  std::vector<Literal> next;  ///< of each register; all begin with 0
  std::vector<Literal> outputs;
  std::vector<Literal> failing;               ///< 1 where an assertion fails
  std::vector<std::array<Literal, 2>> gates;  ///< read variables of smaller numbers

  Literal input(std::size_t n) const { return static_cast<Literal>(2 * (1 + n)); }
  Literal register_at(std::size_t n) const { return input(inputs + n); }
  Literal all(Literal a, Literal b);  ///< of the two; a gate, if it needs one
  Literal any(Literal a, Literal b) { return all(a ^ 1, b ^ 1) ^ 1; }
  Literal differ(Literal a, Literal b) { return any(all(a, b ^ 1), all(a ^ 1, b)); }
  /// The outputs of a circuit without registers, for those values of its inputs.
  std::vector<Literal> copy(const AndCircuit& circuit, const std::vector<Literal>& values);
};

/// Throws RtlError if the text is none, or has registers that begin otherwise, or more than
/// outputs and assertions to look at.
AndCircuit read_circuit(const std::string& aiger);
/// Without assertions.
std::string aiger_of(const AndCircuit& circuit);

/// The same circuit, where some inputs, by their numbers from 0, are constants for whatever reads
/// them; they stay in the list of inputs.
AndCircuit with_constant_inputs(AndCircuit circuit, const std::map<std::size_t, bool>& constants);

/// One clock of the same circuit: registers are inputs, behind the others, and their next values
/// outputs, before the others. What is failing stays so.
AndCircuit without_registers(AndCircuit circuit);

/// Of a circuit without registers the gates that some literals need, which are its outputs.
AndCircuit cone_of(const AndCircuit& circuit, const std::vector<Literal>& outputs);

/// 64 values of each variable at once.
class CircuitLanes {
 public:
  explicit CircuitLanes(const AndCircuit& circuit);
  std::uint64_t& input(std::size_t n) { return values_[1 + n]; }
  std::uint64_t& register_at(std::size_t n) { return values_[1 + circuit_.inputs + n]; }
  /// Gates follow from inputs and registers.
  void settle();
  /// Registers take their next values.
  void clock();
  std::uint64_t of(Literal literal) const {
    return values_[literal / 2] ^ ((literal & 1) != 0 ? ~std::uint64_t{0} : 0);
  }

 private:
  const AndCircuit& circuit_;
  std::vector<std::uint64_t> values_;
};

}  // namespace racebeam
