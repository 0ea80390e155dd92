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
#include <vector>

#include "tb/base/work_clock.h"
#include "tb/signoff/aiger.h"
#include "tb/signoff/always_zero.h"
#include "tb/signoff/named_circuit.h"
#include "tb/signoff/value_groups.h"

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
  void choose(std::mt19937_64& random, std::vector<std::uint64_t>& state) const {
    groups_.choose(random, state);
  }
  /// States of the short run; or none.
  const std::vector<std::vector<std::uint64_t>>& seen() const { return seen_; }
  /// The lanes in which all claims hold.
  std::uint64_t claimed(const std::vector<std::uint64_t>& state) const;
  std::size_t claims() const { return claims_.outputs.size(); }
  /// Registers that always have the same value.
  std::map<std::size_t, bool> constants() const { return groups_.constants(); }

 private:
  AndCircuit one_clock(const AndCircuit& circuit) const;
  void run_a_while(const AndCircuit& circuit);
  void run_from_any(const AndCircuit& circuit);
  bool close(const AndCircuit& circuit, WorkClock::time_point end);
  ZeroAnswer leads_out(const AndCircuit& circuit, std::size_t first, std::size_t count) const;
  void take_found(const AndCircuit& circuit, const std::vector<bool>& inputs);
  void keep_proved(const AndCircuit& circuit, WorkClock::time_point end);
  void add_claimed(const ValueGroups& groups, WorkClock::time_point end);
  Literal claimed(AndCircuit& circuit, const std::vector<Literal>& state) const;

  std::chrono::seconds for_one_{};  // question
  ValueGroups groups_;
  AndCircuit claims_;
  std::vector<std::vector<std::uint64_t>> seen_;
};

}  // namespace racebeam
