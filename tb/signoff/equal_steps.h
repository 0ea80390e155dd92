// Whether a mutant goes beside its unit, clock by clock, with equal outputs.
//
// Registers of the two are equal, except where they do not count: in a state of the unit, told by
// one of its words, some registers of the mutant may have any value; and the word of the mutant may
// have another value there, always the same one. What is so begins with nothing, and grows as long
// as some clock leads out of it. If then no output can differ, the mutant is equal.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "tb/signoff/aiger.h"
#include "tb/signoff/state_values.h"

namespace racebeam {

class EqualSteps {
 public:
  static constexpr std::size_t MostBits = 6;  ///< of a word

  /// Two circuits with the same inputs and registers. The word may be empty: then a register counts
  /// in all states or in none.
  EqualSteps(const AndCircuit& unit, const AndCircuit& mutant, const StateValues& possible,
             RegisterWord word);
  /// False: it is not so, or not known in that time. Throws MissingTool, Interrupted.
  bool hold(std::chrono::steady_clock::time_point end);

 private:
  using Lanes = std::uint64_t;
  /// Of a value of the word.
  struct Where {
    bool reached = false;
    unsigned mutant = 0;     // its value there
    std::vector<bool> free;  // registers of the mutant that may have any value
  };
  /// The same of a state, whose bits are lanes or literals.
  template <class Bit>
  struct Known {
    Bit reached;
    std::vector<Bit> word;  // of the mutant
    std::vector<Bit> free;
  };

  template <class Bits>
  Known<typename Bits::Bit> known(Bits bits, const std::vector<typename Bits::Bit>& state) const;
  template <class Bits>
  std::vector<typename Bits::Bit> beside(Bits bits, const std::vector<typename Bits::Bit>& state,
                                         const std::vector<typename Bits::Bit>& any) const;
  std::vector<Lanes> random_lanes(std::size_t count);
  std::vector<Lanes> random_state();
  void run(const std::vector<Lanes>& inputs, const std::vector<Lanes>& state,
           const std::vector<Lanes>& any);
  void run_a_while(std::chrono::steady_clock::time_point end);
  void run_around(const std::vector<bool>& values, unsigned value);
  void grow();
  AndCircuit question(unsigned value) const;

  const AndCircuit& unit_;
  const AndCircuit& mutant_;
  const StateValues& possible_;
  const RegisterWord word_;
  std::vector<bool> in_word_;  // by register
  std::vector<Where> where_;   // by value
  std::mt19937_64 random_{1};
  CircuitLanes unit_lanes_, mutant_lanes_;
  bool grew_ = false, differ_ = false;
};

}  // namespace racebeam
