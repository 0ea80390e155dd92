// A mutant is equal if its registers are the unit's wherever they count.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/equal_steps.h"

#include <gtest/gtest.h>

namespace racebeam {
namespace {

bool are_equal(const AndCircuit& unit, const AndCircuit& mutant, const RegisterWord& word,
               const StateValues& possible = {}, const RegisterWord& wide = {}) {
  return EqualSteps(unit, mutant, possible, word, wide)
      .hold(WorkClock::now() + std::chrono::seconds(60), EqualSteps::Thorough);
}

Literal chosen(AndCircuit& circuit, Literal if_so, Literal a, Literal b) {
  return circuit.any(circuit.all(if_so, a), circuit.all(if_so ^ 1, b));
}

/// Takes a bit when it starts, and shows it in the next clock, when it is busy. Registers: busy,
/// and the bit. The mutant takes a bit whenever it is not busy.
AndCircuit taker(bool mutant) {
  AndCircuit circuit;
  circuit.inputs = 2;
  circuit.next = {False, False};
  const Literal busy = circuit.register_at(0), bit = circuit.register_at(1);
  const Literal starts = circuit.all(circuit.input(0), busy ^ 1);
  circuit.next = {starts, chosen(circuit, mutant ? busy ^ 1 : starts, circuit.input(1), bit)};
  circuit.outputs = {circuit.all(busy, bit), busy};
  return circuit;
}

/// Goes from 0 to `first`, to the other of 1 and 2, and to 0 again; tells when it is 0.
AndCircuit ring(unsigned first) {
  AndCircuit circuit;
  circuit.next = {False, False};
  const Literal low = circuit.register_at(0), high = circuit.register_at(1);
  const Literal none = circuit.all(low ^ 1, high ^ 1);
  circuit.next = first == 1 ? std::vector<Literal>{none, low} : std::vector<Literal>{high, none};
  circuit.outputs = {none};
  return circuit;
}

TEST(EqualStepsTest, ACircuitIsEqualToItself) {
  EXPECT_TRUE(are_equal(taker(false), taker(false), {}));
  EXPECT_TRUE(are_equal(taker(false), taker(false), {0}));
}

TEST(EqualStepsTest, ARegisterNeedNotBeEqualWhereItDoesNotCount) {
  EXPECT_TRUE(are_equal(taker(false), taker(true), {0}));
  EXPECT_FALSE(are_equal(taker(false), taker(true), {})) << "it counts in some state";
  EXPECT_FALSE(are_equal(taker(false), taker(true), {1})) << "the bit does not tell when";
}

TEST(EqualStepsTest, ARegisterThatIsNeverReadNeedNotBeEqualAtAll) {
  AndCircuit unit = taker(false), mutant = taker(true);
  for (AndCircuit* circuit : {&unit, &mutant}) circuit->outputs.erase(circuit->outputs.begin());
  EXPECT_TRUE(are_equal(unit, mutant, {}));
}

TEST(EqualStepsTest, StatesMayHaveOtherNumbers) {
  EXPECT_TRUE(are_equal(ring(1), ring(2), {0, 1}));
  EXPECT_FALSE(are_equal(ring(1), ring(2), {0}));
}

// After 1 the mutant is at 2, where it does what both do at 0.
TEST(EqualStepsTest, AStateMayBeSeveralOfTheMutant) {
  AndCircuit unit;
  unit.inputs = 1;
  unit.next = {False, False};
  const Literal low = unit.register_at(0), high = unit.register_at(1);
  unit.next[0] = unit.all(unit.input(0), low ^ 1);
  unit.outputs = {unit.all(low, high ^ 1)};
  AndCircuit mutant = unit;
  mutant.next[1] = low;
  EXPECT_TRUE(are_equal(unit, mutant, {0, 1}));
  EXPECT_FALSE(are_equal(unit, mutant, {})) << "at 3 the output would differ";
}

TEST(EqualStepsTest, AnOutputMayNotDiffer) {
  AndCircuit mutant = taker(false);
  mutant.outputs[0] = mutant.all(mutant.outputs[0], mutant.input(0));
  EXPECT_FALSE(are_equal(taker(false), mutant, {0}));
}

// Forty inputs have to be 1 in one clock: no random run shows it.
TEST(EqualStepsTest, ARareDifferenceIsOneToo) {
  AndCircuit unit;
  unit.inputs = 40;
  unit.next = {False};
  AndCircuit mutant = unit;
  Literal all = True;
  for (std::size_t n = 0; n < mutant.inputs; ++n) all = mutant.all(all, mutant.input(n));
  mutant.next = {all};
  EXPECT_TRUE(are_equal(unit, mutant, {})) << "nobody reads the register";
  unit.outputs = mutant.outputs = {unit.register_at(0)};
  EXPECT_FALSE(are_equal(unit, mutant, {}));
}

// The register that differs is read only where the ring is at 3.
TEST(EqualStepsTest, OnlyPossibleStatesCount) {
  AndCircuit unit = ring(1), mutant;
  const StateValues possible(unit, {{0, 1}}, std::chrono::seconds(60));
  mutant = unit;
  mutant.outputs = {
      mutant.any(unit.outputs[0], mutant.all(mutant.register_at(0), mutant.register_at(1)))};
  EXPECT_TRUE(are_equal(unit, mutant, {}, possible));
  EXPECT_FALSE(are_equal(unit, mutant, {}));
  EXPECT_TRUE(are_equal(unit, mutant, {0, 1})) << "a word's values are looked for, too";
}

/// Takes a number of seven bits, its registers from 1 on, and a bit; shows the bit unless the
/// number is 0, or, with `always`, whatever it is. The mutant turns the bit where the number is 0.
AndCircuit divider(bool mutant, bool always = false) {
  AndCircuit circuit;
  circuit.inputs = 8;
  circuit.next.assign(8, False);
  Literal is_zero = True, was_zero = True;
  for (std::size_t n = 1; n < 8; ++n) {
    circuit.next[n] = circuit.input(n);
    is_zero = circuit.all(is_zero, circuit.input(n) ^ 1);
    was_zero = circuit.all(was_zero, circuit.register_at(n) ^ 1);
  }
  const Literal bit = circuit.input(0);
  circuit.next[0] = mutant ? chosen(circuit, is_zero, bit ^ 1, bit) : bit;
  circuit.outputs = {circuit.all(circuit.register_at(0), always ? True : was_zero ^ 1), was_zero};
  return circuit;
}

TEST(EqualStepsTest, ThatAWideWordIsZeroMayTellAState) {
  const RegisterWord number{1, 2, 3, 4, 5, 6, 7};
  const AndCircuit unit = divider(false);
  EXPECT_TRUE(are_equal(unit, divider(true), {}, {}, number));
  EXPECT_FALSE(are_equal(unit, divider(true), {})) << "the bit counts in some state";
  EXPECT_FALSE(are_equal(unit, divider(true), {}, {}, {2, 3, 4, 5, 6, 7})) << "nor does this tell";
  EXPECT_FALSE(are_equal(divider(false, true), divider(true, true), {}, {}, number))
      << "it is seen";
  const StateValues possible(unit, {number}, std::chrono::seconds(60));
  EXPECT_TRUE(are_equal(unit, divider(true), {}, possible, number));
}

}  // namespace
}  // namespace racebeam
