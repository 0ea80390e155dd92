// Which values registers can have: those of small words together, of wide ones bit by bit.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/state_values.h"

#include <gtest/gtest.h>

namespace racebeam {
namespace {

/// Whether some values of all registers are possible.
bool is_possible(const StateValues& values, unsigned registers, std::size_t count) {
  AndCircuit circuit;
  std::vector<Literal> state;
  for (std::size_t n = 0; n < count; ++n) state.push_back((registers >> n) & 1 ? True : False);
  const Literal hold = values.hold(circuit, state);
  EXPECT_TRUE(circuit.gates.empty()) << "constants need none";
  return hold == True;
}

/// A counter 0, 1, 2, 0... that an input lets count.
AndCircuit counter_to_three() {
  AndCircuit circuit;
  circuit.inputs = 1;
  circuit.next = {False, False};
  const Literal count = circuit.input(0), low = circuit.register_at(0),
                high = circuit.register_at(1);
  const Literal none = circuit.all(low ^ 1, high ^ 1);
  const Literal to_low = circuit.all(count, none), keeps_low = circuit.all(count ^ 1, low);
  const Literal to_high = circuit.all(count, low), keeps_high = circuit.all(count ^ 1, high);
  circuit.next = {circuit.any(to_low, keeps_low), circuit.any(to_high, keeps_high)};
  return circuit;
}

TEST(StateValuesTest, NothingIsKnownAtFirst) { EXPECT_TRUE(is_possible(StateValues(), 3, 2)); }

TEST(StateValuesTest, ACounterDoesNotLeaveItsValues) {
  const StateValues values(counter_to_three(), {{0, 1}}, std::chrono::seconds(60));
  for (const unsigned value : {0u, 1u, 2u}) EXPECT_TRUE(is_possible(values, value, 2)) << value;
  EXPECT_FALSE(is_possible(values, 3, 2));
}

TEST(StateValuesTest, BitsApartTellLess) {
  const StateValues values(counter_to_three(), {{0}, {1}}, std::chrono::seconds(60));
  EXPECT_TRUE(is_possible(values, 3, 2));
}

// A register that stays 0, and seven that take an input each.
TEST(StateValuesTest, OfAWideWordABitMayBeConstant) {
  AndCircuit circuit;
  circuit.inputs = 7;
  RegisterWord word;
  for (std::size_t n = 0; n < 8; ++n) {
    circuit.next.push_back(n < 7 ? circuit.input(n) : False);
    word.push_back(n);
  }
  const StateValues values(circuit, {word}, std::chrono::seconds(60));
  EXPECT_TRUE(is_possible(values, 0x7f, 8));
  EXPECT_FALSE(is_possible(values, 0x80, 8));
}

// What a short run hardly reaches: twelve inputs have to be 1 in one clock.
TEST(StateValuesTest, ARareValueIsTakenInWhereAClockLeadsToIt) {
  AndCircuit circuit;
  circuit.inputs = 40;
  circuit.next = {False};
  Literal all = True;
  for (std::size_t n = 0; n < circuit.inputs; ++n) all = circuit.all(all, circuit.input(n));
  circuit.next = {all};
  EXPECT_TRUE(is_possible(StateValues(circuit, {{0}}, std::chrono::seconds(60)), 1, 1));
}

TEST(StateValuesTest, WordsAreFoundByWhatTheyDo) {
  const NamedCircuit like{counter_to_three(), {{"count", 0}}, {{0, 1}}};
  NamedCircuit other = like;
  std::swap(other.circuit.next[0], other.circuit.next[1]);
  for (auto& gate : other.circuit.gates)
    for (Literal& side : gate)
      if (side / 2 == 2 || side / 2 == 3) side ^= 2;
  for (Literal& next : other.circuit.next)
    if (next / 2 == 2 || next / 2 == 3) next ^= 2;
  other.words.clear();
  EXPECT_EQ(words_as_in(like, other), (std::vector<RegisterWord>{{1, 0}}));
}

}  // namespace
}  // namespace racebeam
