// Which values registers can have: those of small words together, of wide ones bit by bit, and what
// is claimed of them.
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

/// Two registers that take each other's value.
AndCircuit exchange() {
  AndCircuit circuit;
  circuit.next = {False, False};
  circuit.next = {circuit.register_at(1), circuit.register_at(0)};
  return circuit;
}

/// Claims that some of two registers are 0: those of which the number has a bit.
AndCircuit are_zero(unsigned which) {
  AndCircuit claims;
  claims.inputs = 2;
  for (std::size_t n = 0; n < 2; ++n)
    if (((which >> n) & 1) != 0) claims.outputs.push_back(claims.input(n));
  return claims;
}

/// Bits of a product of two numbers of 16 bits, each multiplied by hand.
std::vector<Literal> product(AndCircuit& circuit, const std::vector<Literal>& a,
                             const std::vector<Literal>& b) {
  std::vector<Literal> sum(a.size() + b.size(), False);
  for (std::size_t n = 0; n < b.size(); ++n) {
    Literal carry = False;
    for (std::size_t bit = 0; bit < a.size(); ++bit) {
      const Literal term = circuit.all(a[bit], b[n]), old = sum[n + bit];
      const auto differ = [&](Literal x, Literal y) {
        return circuit.any(circuit.all(x, y ^ 1), circuit.all(x ^ 1, y));
      };
      const Literal half = differ(term, old);
      sum[n + bit] = differ(half, carry);
      carry = circuit.any(circuit.all(term, old), circuit.all(half, carry));
    }
    sum[n + a.size()] = carry;
  }
  return sum;
}

// a * b is b * a, which nobody finds out in a second.
TEST(StateValuesTest, WhatIsNotKnownOfAWordIsNotNeededOfOthers) {
  constexpr std::size_t Bits = 16;
  AndCircuit circuit;
  circuit.inputs = 1 + 2 * Bits;
  circuit.next.assign(4, False);
  const Literal count = circuit.input(0), low = circuit.register_at(0),
                high = circuit.register_at(1);
  circuit.next[0] = circuit.all(count, circuit.all(low ^ 1, high ^ 1));
  circuit.next[1] = circuit.all(count, low);
  std::vector<Literal> a, b;
  for (std::size_t n = 0; n < Bits; ++n)
    a.push_back(circuit.input(1 + n)), b.push_back(circuit.input(1 + Bits + n));
  const auto ab = product(circuit, a, b), ba = product(circuit, b, a);
  for (const std::size_t n : {2, 3})
    circuit.next[n] = circuit.any(circuit.all(ab[Bits + n], ba[Bits + n] ^ 1),
                                  circuit.all(ab[Bits + n] ^ 1, ba[Bits + n]));
  const StateValues values(circuit, {{2, 3}, {0, 1}}, std::chrono::seconds(6));
  EXPECT_TRUE(is_possible(values, 4, 4)) << "not found out";
  EXPECT_FALSE(is_possible(values, 3, 4)) << "a counter to three";
}

TEST(StateValuesTest, AClaimIsKeptIfNoClockLeadsOutOfIt) {
  AndCircuit circuit, equal;
  circuit.inputs = 1;
  circuit.next = {circuit.input(0), circuit.input(0)};
  equal.inputs = 2;
  equal.outputs = {equal.any(equal.all(equal.input(0), equal.input(1) ^ 1),
                             equal.all(equal.input(0) ^ 1, equal.input(1)))};
  const StateValues values(circuit, {{0}, {1}}, std::chrono::seconds(60), equal);
  EXPECT_TRUE(is_possible(values, 3, 2));
  EXPECT_FALSE(is_possible(values, 1, 2));
  EXPECT_EQ(values.claimed({0b0011, 0b0101}), ~std::uint64_t{0b0110}) << "by lanes";
}

// Two registers count together 0, 1, 2, 0...; the third takes the first where that is wrong.
TEST(StateValuesTest, WhatClaimsImplyIsKnownOfEachRegister) {
  AndCircuit circuit = counter_to_three();
  const Literal low = circuit.register_at(0), high = circuit.register_at(1);
  circuit.next.push_back(False);  // the gates come behind it
  for (auto& gate : circuit.gates)
    for (Literal& side : gate)
      if (side / 2 > 3) side += 2;
  for (Literal& next : circuit.next)
    if (next / 2 > 3) next += 2;
  circuit.next[2] = circuit.all(low, high);
  AndCircuit claims;
  claims.inputs = 3;
  claims.outputs = {claims.all(claims.input(0), claims.input(1)), claims.input(2)};
  const StateValues values(circuit, {{0}, {1}, {2}}, std::chrono::seconds(60), claims);
  EXPECT_EQ(values.claims(), 2u);
  EXPECT_EQ(values.constants(), (std::map<std::size_t, bool>{{2, false}}));
}

TEST(StateValuesTest, ClaimsMayNeedEachOther) {
  const auto kept = [](const AndCircuit& claims) {
    return StateValues(exchange(), {}, std::chrono::seconds(60), claims).claims();
  };
  EXPECT_EQ(kept(are_zero(3)), 2u);
  EXPECT_EQ(kept(are_zero(1)), 0u) << "the other register may be 1 if nobody claims that it is not";
}

TEST(StateValuesTest, AWrongClaimIsDropped) {
  EXPECT_EQ(StateValues(counter_to_three(), {}, std::chrono::seconds(60), are_zero(1)).claims(),
            0u);
  AndCircuit at_start = are_zero(1);
  at_start.outputs[0] ^= 1;
  EXPECT_EQ(StateValues(exchange(), {}, std::chrono::seconds(60), at_start).claims(), 0u)
      << "it is wrong at the start, though no clock leads out of it";
}

}  // namespace
}  // namespace racebeam
