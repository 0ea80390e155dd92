// Values that the registers of a circuit can have, told of each word alone, and by claims.
//
// The values begin with what a short run shows. As long as yosys-abc finds a clock that leads out
// of them, that value is taken in: in the end none does. Of the claims those are dropped that a
// clock leads out of though all others hold.
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

#include "tb/base/work_clock.h"
#include "tb/signoff/aiger.h"
#include "tb/signoff/named_circuit.h"

namespace racebeam {

class StateValues {
 public:
  /// Nothing is known: any value.
  StateValues() = default;
  /// All registers begin with 0; inputs have any values. `claims` has the registers as inputs, and
  /// outputs that are 1 where what they claim is wrong. What is not found out within `limit` is not
  /// known. Throws MissingTool, Interrupted.
  StateValues(const AndCircuit& circuit, const std::vector<RegisterWord>& words,
              std::chrono::seconds limit, AndCircuit claims = {});

  // A state may have other registers behind those of the circuit.

  /// Whether all registers have such values, in a circuit in which `state` is their values.
  Literal hold(AndCircuit& circuit, const std::vector<Literal>& state) const;
  /// Puts such values, in 64 lanes, where `state` has others; claims may be wrong of them.
  void choose(std::mt19937_64& random, std::vector<std::uint64_t>& state) const;
  /// States of the short run; or none.
  const std::vector<std::vector<std::uint64_t>>& seen() const { return seen_; }
  /// The lanes in which all claims hold.
  std::uint64_t claimed(const std::vector<std::uint64_t>& state) const;
  std::size_t claims() const { return claims_.outputs.size(); }
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
  bool close(const AndCircuit& circuit, WorkClock::time_point end);
  void take_found(const AndCircuit& circuit, const std::vector<bool>& inputs);
  void close_each(const AndCircuit& circuit, WorkClock::time_point end);
  static Literal holds(const Group& group, AndCircuit& circuit, const std::vector<Literal>& state);
  void keep_proved(const AndCircuit& circuit, WorkClock::time_point end);
  void add_claimed(const std::vector<Group>& groups, WorkClock::time_point end);
  Literal claimed(AndCircuit& circuit, const std::vector<Literal>& state) const;

  std::chrono::seconds for_one_{};  // question
  std::vector<Group> groups_;       // of which some value is not possible
  AndCircuit claims_;
  std::vector<std::vector<std::uint64_t>> seen_;
};

}  // namespace racebeam
