// Values that words of registers may have, each word alone.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "tb/signoff/aiger.h"
#include "tb/signoff/named_circuit.h"

namespace racebeam {

/// Registers have the same numbers in all that is passed here; a state may have more of them.
class ValueGroups {
 public:
  struct Group {
    RegisterWord bits;
    std::set<unsigned> values;
  };

  ValueGroups() = default;
  /// All begin with 0. Of words that are not small each bit is a group.
  explicit ValueGroups(const std::vector<RegisterWord>& words);

  const std::vector<Group>& all() const { return groups_; }
  void add(const Group& group) { groups_.push_back(group); }
  void drop_last() { groups_.pop_back(); }
  void drop(std::size_t n) { groups_.erase(groups_.begin() + static_cast<std::ptrdiff_t>(n)); }
  void drop_bits();  ///< groups of one bit

  /// Takes in the next values, in those lanes; whether some are new. Groups that may have any value
  /// are dropped.
  bool take(const AndCircuit& circuit, const CircuitLanes& lanes, std::uint64_t which);
  /// Puts such values, in 64 lanes, where `state` has others.
  void choose(std::mt19937_64& random, std::vector<std::uint64_t>& state) const;
  /// Whether the registers have such values; of that many groups, from one on.
  Literal hold(AndCircuit& circuit, const std::vector<Literal>& state, std::size_t first,
               std::size_t count) const;
  Literal hold(AndCircuit& circuit, const std::vector<Literal>& state) const {
    return hold(circuit, state, 0, groups_.size());
  }
  /// Registers that always have the same value.
  std::map<std::size_t, bool> constants() const;

 private:
  std::vector<Group> groups_;  // of which some value is not possible
};

}  // namespace racebeam
