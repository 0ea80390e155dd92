// Stimulus that the chip never makes: random values on all inputs of a unit, in short episodes.
//
// Each episode draws anew how each input behaves: held, random, at the boundaries of its width, or
// seldom changed; resets come at random clocks. Short episodes with fresh settings reach states
// that one long run of the same noise does not.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <vector>

#include "tb/legal_inputs.h"
#include "tb/unit_bench.h"

namespace racebeam {

class RandomTraffic {
 public:
  /// For the inputs of the unit on `bench`, in the widths of a chip with the knobs `k`; the same
  /// seed makes the same traffic.
  RandomTraffic(UnitBench& bench, const knobs& k, unsigned seed);

  /// New values for the next clock.
  void next();

 private:
  enum Manner { Held, Random, Boundary, Seldom };
  struct Input {
    UnitBench::Pin* pin;
    Manner manner = Random;
    int reset = -1;  ///< value that resets, -1: not a reset
  };

  void begin_episode();
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }
  int boundary(int bits);

  const LegalInputs legal_;
  std::mt19937 random_;
  std::vector<Input> inputs_;
  int left_ = 0;          // clocks of the episode
  int reset_every_ = 64;  // clocks between resets, on average
};

}  // namespace racebeam
