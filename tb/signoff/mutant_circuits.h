// What yosys-abc is asked of: circuits of a unit and its mutants, in AIGER.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tb/signoff/aiger.h"
#include "tb/signoff/mutant_circuit.h"
#include "tb/signoff/mutant_netlist.h"
#include "tb/signoff/proved_mutants.h"
#include "tb/signoff/state_values.h"
#include "tb/twin/legal_inputs.h"
#include "tb/twin/port_traffic.h"

namespace racebeam {

/// What a proof is asked of: `ports` of the unit, without clocks of traffic.
struct ProofOfMutants {
  const MutantNetlist& netlist;
  const PortTraffic& ports;
  const LegalInputs& legal;
  std::chrono::milliseconds limit;  ///< for each mutant
  MutantNames proved{};             ///< equal, as a file tells
  bool again = false;               ///< the cache is not believed
};

/// The unit and the mutant side by side; all registers start at 0 and see one clock of reset, then
/// any inputs that a chip can have. The only output is 1 when outputs of the two differ.
/// Registers without a reset start equal so.
/// `choice_bits`: of the input that chooses a mutant.
std::string miter_module(const ProofOfMutants& proof, int choice_bits);

/// Names what a proof is asked of, whichever mutants are chosen; yosys's version is in it, as a
/// netlist's text tells it.
std::string circuit_key(const ProofOfMutants& proof);

struct MutantCircuits {
  std::optional<MutantCircuit> miter;  ///< none of a unit with more memory than can be looked at
  MutantCircuit
      step;  ///< mutants alone; inputs that no chip has are replaced by one that it can have; of
             ///< more memory than that, what it is given are outputs, and what it gives, inputs
  std::string miter_map;
  std::vector<RegisterWord> words;  ///< of the step
  AndCircuit claims;                ///< of the step's registers: 1 where an assertion fails
};

/// Throws RtlError, MissingTool, Interrupted.
MutantCircuits mutant_circuits(const ProofOfMutants& proof, const std::vector<Mutant>& mutants);

/// What the circuits follow from, but for netlist, mutant and miter_module().
std::string circuit_commands(const ProofOfMutants& proof);

/// Whether a chip can have these inputs: a row for each clock, in it a value for each input.
bool is_legal(const ProofOfMutants& proof, const std::vector<std::vector<std::uint64_t>>& rows);

}  // namespace racebeam
