// Values that the registers of a circuit can have, told of each word alone.
//
// They begin with what a short run shows. As long as yosys-abc finds a clock that leads out of
// them, that value is taken in: in the end none does.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "tb/signoff/aiger.h"

namespace racebeam {

/// The bits of a word by the numbers of their registers.
using RegisterWord = std::vector<std::size_t>;

class StateValues {
 public:
  /// Nothing is known: any value.
  StateValues() = default;
  /// All registers begin with 0; inputs have any values. What is not found out within `limit` is
  /// not known. Throws MissingTool, Interrupted.
  StateValues(const AndCircuit& circuit, const std::vector<RegisterWord>& words,
              std::chrono::seconds limit);

  /// Whether all registers have such values, in a circuit in which `state` is their values.
  Literal hold(AndCircuit& circuit, const std::vector<Literal>& state) const;
  /// Puts such values, in 64 lanes, where `state` has others.
  void choose(std::mt19937_64& random, std::vector<std::uint64_t>& state) const;
  /// Registers that always have the same value.
  std::map<std::size_t, bool> constants() const;

 private:
  struct Group {
    RegisterWord bits;
    std::set<unsigned> values;
  };

  AndCircuit one_clock(const AndCircuit& circuit) const;
  void run_a_while(const AndCircuit& circuit);
  void take(const AndCircuit& circuit, const CircuitLanes& lanes, std::uint64_t which);
  void forget_free();
  bool close(const AndCircuit& circuit, std::chrono::steady_clock::time_point end);

  std::vector<Group> groups_;  // of which some value is not possible
};

/// A circuit whose inputs and registers have names.
struct NamedCircuit {
  AndCircuit circuit;
  std::map<std::string, std::size_t> inputs;  ///< by name and bit
  std::vector<RegisterWord> words;            ///< of all registers or some
};

/// The words of `circuit` as `like` has them, which does the same with the same inputs. Only a
/// guess: registers that have the same values in a short run are the same.
std::vector<RegisterWord> words_as_in(const NamedCircuit& like, const NamedCircuit& circuit);

}  // namespace racebeam
