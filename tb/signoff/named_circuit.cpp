// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/named_circuit.h"

#include <cstdint>
#include <functional>
#include <string>

#include "tb/base/reset_value.h"

namespace racebeam {

namespace {

using Lanes = std::uint64_t;

constexpr unsigned Rounds = 512, Densities = 6;

/// A number that follows from two, as splitmix64 makes it.
Lanes mixed(Lanes a, Lanes b) {
  Lanes value = a + (b + 1) * 0x9e3779b97f4a7c15;
  value = (value ^ value >> 30) * 0xbf58476d1ce4e5b9;
  value = (value ^ value >> 27) * 0x94d049bb133111eb;
  return value ^ value >> 31;
}

/// 64 bits that follow from a number, of which a half is 1, a quarter, ..., or a 64th.
Lanes lanes_of(Lanes seed, Lanes density) {
  Lanes lanes = mixed(seed, 0);
  for (density %= Densities; density > 0; --density) lanes &= mixed(seed, density);
  return lanes;
}

/// What each register does, as one number. They begin alike but for names that both circuits have;
/// registers that are alike have the same values, and those that then take different ones are alike
/// no more. In some rounds a port or a register has few ones: small numbers are more often equal.
std::vector<Lanes> deeds_of(const NamedCircuit& named, const NamedCircuit& other) {
  std::vector<Lanes> deeds(named.circuit.next.size());
  for (const auto& [name, n] : named.registers)
    if (other.registers.count(name) > 0) deeds[n] = std::hash<std::string>{}(name);
  CircuitLanes lanes(named.circuit);
  for (Lanes round = 1; round <= Rounds; ++round) {
    Lanes bit = 0;
    for (const auto& [name, input] : named.inputs) {
      const Lanes port = std::hash<std::string>{}(name.substr(0, name.find(' ')));
      lanes.input(input) = lanes_of(mixed(++bit, round), mixed(port, round));
    }
    for (std::size_t n = 0; n < deeds.size(); ++n)
      lanes.register_at(n) = lanes_of(mixed(deeds[n], round), mixed(deeds[n] + 1, round));
    lanes.settle();
    for (std::size_t n = 0; n < deeds.size(); ++n)
      deeds[n] = mixed(deeds[n], lanes.of(named.circuit.next[n]));
  }
  return deeds;
}

constexpr std::size_t None = ~std::size_t{0};

/// For each register of `like` one of `circuit` that does the same, or None. Of several the first
/// is that of the first.
std::vector<std::size_t> same_registers(const NamedCircuit& like, const NamedCircuit& circuit) {
  std::multimap<Lanes, std::size_t> by_deed;
  const auto deeds = deeds_of(circuit, like);
  for (std::size_t n = 0; n < deeds.size(); ++n) by_deed.emplace(deeds[n], n);
  std::vector<std::size_t> same;
  for (const Lanes deed : deeds_of(like, circuit)) {
    const auto at = by_deed.find(deed);
    same.push_back(at == by_deed.end() ? None : at->second);
    if (at != by_deed.end()) by_deed.erase(at);
  }
  return same;
}

}  // namespace

std::vector<RegisterWord> words_as_in(const NamedCircuit& like, const NamedCircuit& circuit) {
  const std::vector<std::size_t> same = same_registers(like, circuit);
  std::vector<bool> named(circuit.circuit.next.size());
  std::vector<RegisterWord> found;
  for (const RegisterWord& word : like.words) {
    found.emplace_back();
    for (const std::size_t bit : word) {
      if (same[bit] == None) continue;
      found.back().push_back(same[bit]);
      named[same[bit]] = true;
    }
  }
  for (std::size_t n = 0; n < named.size(); ++n)
    if (!named[n]) found.push_back({n});
  return found;
}

AndCircuit claims_as_in(const NamedCircuit& like, const NamedCircuit& circuit) {
  AndCircuit claims;
  claims.inputs = circuit.circuit.next.size();
  std::vector<Literal> values(like.circuit.inputs, False);
  for (const auto& [name, input] : like.inputs)
    if (reset_value(name.substr(0, name.find(' '))) == 0) values[input] = True;
  for (const std::size_t n : same_registers(like, circuit)) {
    if (n == None) return claims;
    values.push_back(claims.input(n));
  }
  AndCircuit step = without_registers(like.circuit);
  step.outputs = step.failing;
  claims.outputs = claims.copy(step, values);
  return claims;
}

}  // namespace racebeam
