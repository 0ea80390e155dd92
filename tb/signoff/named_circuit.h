// A circuit of a unit with the names of its RTL, and what the same is in another one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "tb/signoff/aiger.h"

namespace racebeam {

/// The bits of a word by the numbers of their registers.
using RegisterWord = std::vector<std::size_t>;

/// A circuit whose inputs and registers have names.
struct NamedCircuit {
  AndCircuit circuit;
  std::map<std::string, std::size_t> inputs;          ///< by name and bit: "start_i 0"
  std::vector<RegisterWord> words;                    ///< of all registers or some
  std::map<std::string, std::size_t> registers = {};  ///< by name and bit, all or some
};

/// The words of `circuit` as `like` has them, which does the same with the same inputs. Only a
/// guess: registers are the same that have the same name or else take the same values, from random
/// ones that are equal where the registers may be the same.
std::vector<RegisterWord> words_as_in(const NamedCircuit& like, const NamedCircuit& circuit);

/// What the assertions of `like` say of the registers of `circuit`, by the same guess: a circuit
/// whose inputs are those registers, with an output that is 1 where an assertion fails out of reset
/// while all other inputs are 0, and registers that are not found, as no output needs them. It has
/// to be proved of `circuit`, whatever it says.
AndCircuit claims_as_in(const NamedCircuit& like, const NamedCircuit& circuit);

}  // namespace racebeam
