// Whether a mutant goes beside its unit, clock by clock, with equal outputs.
//
// Registers of the two are equal, except where they do not count: in a state of the unit, told by
// one of its words, some registers of the mutant may have any value, and the word of the mutant one
// of some values. Whether another word, a wide one, is 0 may tell a state, too. What is so begins
// with nothing, and grows as long as some clock leads out of it. If then no output can differ, the
// mutant is equal.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "tb/base/work_clock.h"
#include "tb/signoff/aiger.h"
#include "tb/signoff/reached_pairs.h"
#include "tb/signoff/state_values.h"

namespace racebeam {

class EqualSteps {
 public:
  /// Two circuits with the same inputs and registers. If both words are empty, a register counts in
  /// all states or in none.
  EqualSteps(const AndCircuit& unit, const AndCircuit& mutant, const StateValues& possible,
             const RegisterWord& word, RegisterWord wide = {});
  enum Effort { AtOnce, Thorough };  ///< of each question; or it is not known
  /// False: it is not so, or not known in that time. Throws MissingTool, Interrupted.
  bool hold(WorkClock::time_point end, Effort effort);

 private:
  using Lanes = std::uint64_t;
  std::vector<Lanes> random_lanes(std::size_t count);
  void choose(std::vector<Lanes>& state, std::vector<Lanes>& any);
  Lanes are_possible(const std::vector<Lanes>& state) const;
  Lanes choose_seen(std::vector<Lanes>& state, std::vector<Lanes>& any);
  void run(const std::vector<Lanes>& inputs, const std::vector<Lanes>& state,
           const std::vector<Lanes>& any, Lanes which);
  void run_a_while(WorkClock::time_point end);
  void run_around(const std::vector<bool>& values, unsigned value);
  void grow(Lanes which);

  const RegisterWord wide_;
  const AndCircuit unit_, mutant_;  // with its mark, the last register, if there is a wide word
  const StateValues& possible_;
  ReachedPairs reached_;
  std::mt19937_64 random_{1};
  CircuitLanes unit_lanes_, mutant_lanes_;
  bool grew_ = false, differ_ = false;
};

}  // namespace racebeam
