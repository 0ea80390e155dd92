// What tells in which state a unit is: what most depends on is tried first, wide words last.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/state_told.h"

#include <gtest/gtest.h>

#include <string>

namespace racebeam {
namespace {

const RegisterWord Rare{0}, State{1, 2}, Idle{3, 4, 5, 6, 7, 8, 9},
    Denominator{10, 11, 12, 13, 14, 15, 16};

/// Two gates read the state, one the bit; two depend on the denominator, though one reads it.
std::vector<StateTold> ways() {
  AndCircuit circuit;
  circuit.inputs = 4;
  circuit.next.assign(17, False);
  const auto one = [&](std::size_t bit, std::size_t input) {
    return circuit.all(circuit.register_at(bit), circuit.input(input));
  };
  const Literal divides = one(Denominator[3], 0);
  circuit.outputs = {circuit.all(divides, circuit.input(1)), one(State[1], 2), one(State[1], 3),
                     one(Rare[0], 0), one(Idle[0], 1)};
  return ways_to_tell(circuit, {Rare, Idle, State, Denominator});
}

std::string name(const RegisterWord& word) {
  if (word.empty()) return "-";
  if (word == Rare) return "rare";
  if (word == State) return "state";
  if (word == Idle) return "idle";
  return word == Denominator ? "denominator" : "both";
}

TEST(StateToldTest, NothingComesFirstThenWhatMostGatesReadThenWideWords) {
  std::string all;
  for (const StateTold& told : ways()) all += name(told.word) + "/" + name(told.wide) + " ";
  EXPECT_EQ(all,
            "-/- state/- rare/- both/- -/denominator state/denominator rare/denominator "
            "-/idle state/idle rare/idle ");
}

}  // namespace
}  // namespace racebeam
