// A circuit of a unit with mutants in it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tb/signoff/aiger.h"
#include "tb/signoff/named_circuit.h"

namespace racebeam {

/// A circuit with some mutants in it, of which an input chooses one.
class MutantCircuit {
 public:
  /// `map` tells which input and register of the circuit is which, as yosys' write_aiger -map does.
  MutantCircuit(const std::string& aiger, const std::string& map);
  /// With that mutant chosen, or none, 0.
  AndCircuit with(int number) const;
  /// Without a mutant; those inputs are not named.
  NamedCircuit named() const;

 private:
  NamedCircuit named_;
  std::vector<std::size_t> choice_;  // the inputs that choose a mutant, the lowest bit first
};

}  // namespace racebeam
