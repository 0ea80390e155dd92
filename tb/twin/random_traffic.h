// Stimulus that the chip never makes: random values on all inputs of a unit, in short episodes.
//
// Each episode draws anew how each input behaves: held, random, at the boundaries of its width,
// seldom changed, or counting up with skips; and how often resets come, if at all. Short episodes
// with fresh settings reach states that one long run of the same noise does not; one in eight is
// long, for what only a line or a flight without reset reaches.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <random>
#include <vector>

#include "tb/twin/legal_inputs.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

class RandomTraffic {
 public:
  /// For the inputs of the unit on `bench`, with values that are `legal`; the same seed makes the
  /// same traffic.
  RandomTraffic(UnitBench& bench, LegalInputs legal, unsigned seed);

  /// Calls `begin` with a random number when an episode begins, before its first values.
  void at_episodes(std::function<void(unsigned)> begin) { at_episodes_ = std::move(begin); }
  /// New values for the next clock.
  void next();

 private:
  enum Manner { Held, Random, Boundary, Seldom, Counting, Manners };
  struct Input {
    UnitBench::Pin* pin;
    int reset = -1;  ///< value that resets, -1: not a reset
    Manner manner = Random;
    std::uint64_t value = 0;  ///< before it is made legal
  };

  void begin_episode();
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }
  std::uint64_t boundary(int bits);
  std::uint64_t any_value(int bits);

  const LegalInputs legal_;
  std::mt19937 random_;
  std::vector<Input> inputs_;
  std::function<void(unsigned)> at_episodes_;
  int left_ = 0;         // clocks of the episode
  int reset_every_ = 0;  // clocks between resets, on average; 0: none
};

}  // namespace racebeam
