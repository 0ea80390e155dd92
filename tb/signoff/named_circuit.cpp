// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/named_circuit.h"

#include <cstdint>
#include <functional>
#include <set>
#include <string>

#include "tb/base/reset_value.h"

namespace racebeam {

namespace {

using Lanes = std::uint64_t;

constexpr unsigned Rounds = 512, Densities = 6, Carries = 4;

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

/// Values of the inputs in a round; each port has its own density.
void drive_inputs(const NamedCircuit& named, Lanes round, CircuitLanes& lanes) {
  Lanes bit = 0;
  for (const auto& [name, input] : named.inputs) {
    const Lanes port = std::hash<std::string>{}(name.substr(0, name.find(' ')));
    lanes.input(input) = lanes_of(mixed(++bit, round), mixed(port, round));
  }
}

/// Of registers that are alike, as a number: what follows at once, in a run out of reset, if one
/// alone is inverted.
std::vector<Lanes> effects_of_alike(const NamedCircuit& named, const std::vector<Lanes>& deeds) {
  std::map<Lanes, int> alike;
  for (const Lanes deed : deeds) ++alike[deed];
  const AndCircuit& circuit = named.circuit;
  CircuitLanes lanes(circuit);
  const auto looked_at = [&] {
    std::vector<Lanes> all;
    for (const auto* literals : {&circuit.next, &circuit.outputs})
      for (const Literal literal : *literals) all.push_back(lanes.of(literal));
    return all;
  };
  std::vector<Lanes> effects(deeds.size());
  for (Lanes round = 1; round <= Rounds; ++round) {
    drive_inputs(named, round, lanes);
    for (const auto& [name, input] : named.inputs)
      if (const int value = reset_value(name.substr(0, name.find(' '))); value >= 0)
        lanes.input(input) = (round == 1) == (value == 1) ? ~Lanes{0} : 0;
    lanes.settle();
    const std::vector<Lanes> was = looked_at();
    for (std::size_t n = 0; n < deeds.size(); ++n) {
      if (alike[deeds[n]] < 2) continue;
      lanes.register_at(n) = ~lanes.register_at(n);
      lanes.settle();
      lanes.register_at(n) = ~lanes.register_at(n);
      const std::vector<Lanes> is = looked_at();
      Lanes all = 0;  // in any order of the registers, and of the outputs
      for (std::size_t m = 0; m < is.size(); ++m)
        all += m < deeds.size() ? mixed(deeds[m], was[m] ^ is[m]) : mixed(was[m], is[m]);
      effects[n] = mixed(effects[n], all);
    }
    for (std::size_t n = 0; n < deeds.size(); ++n) lanes.register_at(n) = was[n];
  }
  return effects;
}

/// What each register does, as one number. They begin alike but for names that both circuits have;
/// registers that are alike have the same values, and those that then take different ones are alike
/// no more. In some rounds a port or a register has few ones: small numbers are more often equal;
/// in one of `Carries` all registers have few zeros, and a carry goes through them.
std::vector<Lanes> deeds_of(const NamedCircuit& named, const NamedCircuit& other) {
  std::vector<Lanes> deeds(named.circuit.next.size());
  for (const auto& [name, n] : named.registers)
    if (other.registers.count(name) > 0) deeds[n] = std::hash<std::string>{}(name);
  CircuitLanes lanes(named.circuit);
  for (Lanes round = 1; round <= Rounds; ++round) {
    drive_inputs(named, round, lanes);
    for (std::size_t n = 0; n < deeds.size(); ++n) {
      const Lanes seed = mixed(deeds[n], round);
      lanes.register_at(n) = round % Carries == 0 ? ~lanes_of(seed, Densities - 1)
                                                  : lanes_of(seed, mixed(deeds[n] + 1, round));
    }
    lanes.settle();
    for (std::size_t n = 0; n < deeds.size(); ++n)
      deeds[n] = mixed(deeds[n], lanes.of(named.circuit.next[n]));
  }
  const std::vector<Lanes> effects = effects_of_alike(named, deeds);
  for (std::size_t n = 0; n < deeds.size(); ++n) deeds[n] = mixed(deeds[n], effects[n]);
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
  std::set<RegisterWord> known;  // a word may have several names
  for (const RegisterWord& word : like.words) {
    RegisterWord there;
    for (const std::size_t bit : word) {
      if (same[bit] == None) continue;
      there.push_back(same[bit]);
      named[same[bit]] = true;
    }
    if (known.insert(there).second) found.push_back(there);
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
  for (const std::size_t n : same_registers(like, circuit))
    values.push_back(n == None ? False : claims.input(n));
  AndCircuit step = without_registers(like.circuit);
  step.outputs = step.failing;
  claims.outputs = claims.copy(step, values);
  return claims;
}

}  // namespace racebeam
