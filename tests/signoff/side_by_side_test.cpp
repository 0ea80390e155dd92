// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/side_by_side.h"

#include <gtest/gtest.h>

namespace racebeam {
namespace {

/// (a & b) & `second`, then & c, of the inputs a, b, c.
AndCircuit chain(Literal second) {
  AndCircuit circuit;
  circuit.inputs = 3;
  const auto gate = [&circuit](std::size_t n) { return circuit.register_at(n); };
  circuit.gates = {{circuit.input(0), circuit.input(1)}, {gate(0), second}};
  circuit.gates.push_back({gate(1), circuit.input(2)});
  circuit.outputs = {gate(2)};
  return circuit;
}

/// That and a chain with another `second`, copied into one circuit of three inputs.
SideBySide copied(Literal second, WorkClock::time_point end) {
  AndCircuit into;
  into.inputs = 3;
  const std::vector<Literal> values{into.input(0), into.input(1), into.input(2)};
  return copy_side_by_side(into, chain(into.input(0)), chain(second), values, values, end);
}

TEST(SideBySideTest, TheSameGatesAreShared) {
  const SideBySide both = copied(2, WorkClock::now());  // the first input, as before
  EXPECT_EQ(both.unit, both.mutant);
}

// a & b & a is a & b.
TEST(SideBySideTest, GatesThatSeemToDifferAreFoundEqual) {
  EXPECT_NE(copied(True, WorkClock::now()).unit, copied(True, WorkClock::now()).mutant);
  const SideBySide both = copied(True, WorkClock::now() + std::chrono::minutes(1));
  EXPECT_EQ(both.unit, both.mutant);
}

TEST(SideBySideTest, OthersAreNot) {
  const SideBySide both = copied(False, WorkClock::now() + std::chrono::minutes(1));
  EXPECT_NE(both.unit, both.mutant);
}

// From the second gate on there is one way.
TEST(SideBySideTest, ADifferenceGoesThroughAllGatesOfAChain) {
  EXPECT_EQ(copied(False, WorkClock::now()).changed.size(), 2u);
  EXPECT_TRUE(copied(2, WorkClock::now()).changed.empty()) << "nothing differs";
}

// Of a & b or c & b: two ways from the gate that differs, which one output joins again.
TEST(SideBySideTest, WhereThereAreTwoWaysItGoesThroughNeither) {
  AndCircuit unit, into;
  unit.inputs = into.inputs = 3;
  const auto gate = [&unit](std::size_t n) { return unit.register_at(n); };
  unit.gates = {{unit.input(0), unit.input(1)}};
  unit.gates.push_back({gate(0), unit.input(1)});
  unit.gates.push_back({gate(0), unit.input(2)});
  unit.gates.push_back({gate(1) ^ 1, gate(2) ^ 1});
  AndCircuit mutant = unit;
  mutant.gates[0][1] = True;
  const std::vector<Literal> values{into.input(0), into.input(1), into.input(2)};
  const auto changed = [&](const std::vector<Literal>& outputs) {
    unit.outputs = mutant.outputs = outputs;
    return copy_side_by_side(into, unit, mutant, values, values, WorkClock::now()).changed.size();
  };
  EXPECT_EQ(changed({gate(3)}), 2u);
  EXPECT_EQ(changed({gate(3), gate(2)}), 1u) << "another output shows it, too";
}

/// a & b & c & d ... of many inputs, and of all but the last: samples are the same, a proof is not.
TEST(SideBySideTest, WhatIsTheSameInSamplesOnlyIsNotTaken) {
  constexpr std::size_t Inputs = 40;
  AndCircuit unit, into;
  unit.inputs = into.inputs = Inputs;
  unit.gates = {{unit.input(0), unit.input(1)}};
  std::vector<Literal> values{into.input(0), into.input(1)};
  for (std::size_t n = 2; n < Inputs; ++n) {
    unit.gates.push_back({unit.register_at(n - 2), unit.input(n)});
    values.push_back(into.input(n));
  }
  AndCircuit mutant = unit;
  mutant.gates.back()[1] = True;
  unit.outputs = mutant.outputs = {unit.register_at(Inputs - 2)};
  const SideBySide both = copy_side_by_side(into, unit, mutant, values, values,
                                            WorkClock::now() + std::chrono::minutes(1));
  EXPECT_NE(both.unit, both.mutant);
}

}  // namespace
}  // namespace racebeam
