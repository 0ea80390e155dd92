// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/named_circuit.h"

#include <algorithm>
#include <cstdint>

#include "tb/base/reset_value.h"
#include "tb/signoff/random_run.h"

namespace racebeam {

namespace {

constexpr std::uint64_t Fold = 0x9e3779b97f4a7c15;  // of a trace to a number: odd, few patterns

/// What each register did, as one number.
std::vector<std::uint64_t> traces_of(const NamedCircuit& named) {
  std::vector<std::size_t> inputs;
  for (const auto& [name, input] : named.inputs) inputs.push_back(input);
  std::vector<std::uint64_t> traces(named.circuit.next.size());
  run_from_zero(named.circuit, inputs, [&](const CircuitLanes& lanes) {
    for (std::size_t n = 0; n < traces.size(); ++n)
      traces[n] = (traces[n] ^ lanes.of(named.circuit.next[n])) * Fold;
  });
  return traces;
}

constexpr std::size_t None = ~std::size_t{0};

/// For each register of `like` one of `circuit` that did the same, or None. Of several the first is
/// that of the first: so those that never move are told apart as far as both have one order.
std::vector<std::size_t> same_registers(const NamedCircuit& like, const NamedCircuit& circuit) {
  std::multimap<std::uint64_t, std::size_t> by_trace;
  const auto traces = traces_of(circuit);
  for (std::size_t n = 0; n < traces.size(); ++n) by_trace.emplace(traces[n], n);
  std::vector<std::size_t> same;
  for (const std::uint64_t trace : traces_of(like)) {
    const auto at = by_trace.find(trace);
    same.push_back(at == by_trace.end() ? None : at->second);
    if (at != by_trace.end()) by_trace.erase(at);
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
