// Runs of a circuit from its start with random inputs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "tb/signoff/aiger.h"

namespace racebeam {

/// Calls each(lanes) in every clock of some short runs; inputs are by their numbers. The inputs are
/// the same ones each time for as many: each is 1 in an eighth of the lanes of a run, in a half, or
/// in more.
template <class Each>
void run_from_zero(const AndCircuit& circuit, const std::vector<std::size_t>& inputs,
                   const Each& each) {
  constexpr int Runs = 8, Clocks = 64;
  std::mt19937_64 random(1);
  const auto lanes_of = [&random](unsigned density) {
    const std::uint64_t one = random();
    if (density == 0) return one & random() & random();
    return density == 1 ? one : one | random() | random();
  };
  for (int run = 0; run < Runs; ++run) {
    CircuitLanes lanes(circuit);
    std::vector<unsigned> densities;
    for (std::size_t n = 0; n < inputs.size(); ++n)
      densities.push_back(static_cast<unsigned>(random() % 3));
    for (int clock = 0; clock < Clocks; ++clock) {
      for (std::size_t n = 0; n < inputs.size(); ++n)
        lanes.input(inputs[n]) = lanes_of(densities[n]);
      lanes.settle();
      each(lanes);
      lanes.clock();
    }
  }
}

}  // namespace racebeam
