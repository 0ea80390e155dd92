// Registers of another circuit are found by name and by what they do, and with them what is claimed
// of them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/named_circuit.h"

#include <gtest/gtest.h>

#include <utility>

namespace racebeam {
namespace {

/// The first register takes the input, the second one what the first had; an assertion fails where
/// the first is 0 and the second 1 out of reset.
NamedCircuit pipeline() {
  NamedCircuit named;
  AndCircuit& circuit = named.circuit;
  circuit.inputs = 2;
  circuit.next = {False, False};
  const Literal first = circuit.register_at(0), second = circuit.register_at(1);
  circuit.next = {circuit.input(0), first};
  circuit.failing = {circuit.all(circuit.input(1), circuit.all(first ^ 1, second))};
  named.inputs = {{"data_i 0", 0}, {"rst_ni 0", 1}};
  named.words = {{0, 1}};
  return named;
}

/// The same, its registers in the other order, without names of them and without the assertion.
NamedCircuit exchanged() {
  NamedCircuit named;
  AndCircuit& circuit = named.circuit;
  circuit.inputs = 2;
  circuit.next = {False, False};
  circuit.next = {circuit.register_at(1), circuit.input(0)};
  named.inputs = {{"data_i 0", 0}, {"rst_ni 0", 1}};
  return named;
}

TEST(NamedCircuitTest, WordsAreFoundByWhatTheyDo) {
  EXPECT_EQ(words_as_in(pipeline(), exchanged()), (std::vector<RegisterWord>{{1, 0}}));
}

TEST(NamedCircuitTest, RegistersWithoutANameAreWordsOfTheirOwn) {
  NamedCircuit like = pipeline();
  like.words = {{1}};
  EXPECT_EQ(words_as_in(like, exchanged()), (std::vector<RegisterWord>{{0}, {1}}));
}

TEST(NamedCircuitTest, AnAssertionClaimsTheSameOfThem) {
  const AndCircuit claims = claims_as_in(pipeline(), exchanged());
  ASSERT_EQ(claims.inputs, 2u);
  ASSERT_EQ(claims.outputs.size(), 1u);
  CircuitLanes lanes(claims);
  lanes.input(0) = 0b0011;  // the second one
  lanes.input(1) = 0b0101;
  lanes.settle();
  EXPECT_EQ(lanes.of(claims.outputs[0]) & 0xf, 0b0010u);
}

/// Two registers that keep what they have and are two outputs, in any order. Which of the inputs an
/// output is told with tells which is which.
TEST(NamedCircuitTest, OutputsMayStandInAnotherOrder) {
  NamedCircuit like, other;
  for (NamedCircuit* one : {&like, &other}) {
    AndCircuit& circuit = one->circuit;
    circuit.inputs = 2;
    circuit.next = {False, False};
    const Literal first = circuit.register_at(0), second = circuit.register_at(1);
    circuit.next = {first, second};
    circuit.outputs = {circuit.all(first ^ 1, circuit.input(0)),
                       circuit.all(second ^ 1, circuit.input(1))};
    one->inputs = {{"a_i 0", 0}, {"b_i 0", 1}};
  }
  std::swap(other.circuit.outputs[0], other.circuit.outputs[1]);
  like.words = {{0}};
  EXPECT_EQ(words_as_in(like, other), (std::vector<RegisterWord>{{0}, {1}}));
}

/// Two registers that keep what they have: nothing but a name tells which is which.
TEST(NamedCircuitTest, RegistersOfOneNameAreTheSame) {
  NamedCircuit like, other;
  for (NamedCircuit* one : {&like, &other}) {
    one->circuit.next = {False, False};
    one->circuit.next = {one->circuit.register_at(0), one->circuit.register_at(1)};
  }
  like.words = {{0}};
  like.registers = {{"a_q 0", 0}};
  other.registers = {{"a_q 0", 1}};
  EXPECT_EQ(words_as_in(like, other), (std::vector<RegisterWord>{{1}, {0}}));
}

TEST(NamedCircuitTest, ARegisterThatIsNotFoundIsZeroInAClaim) {
  NamedCircuit other = exchanged();
  other.circuit.next[0] = True;  // where the second one was
  EXPECT_EQ(claims_as_in(pipeline(), other).outputs, std::vector<Literal>{False});
}

}  // namespace
}  // namespace racebeam
