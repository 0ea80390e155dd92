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

/// Registers of a circuit by what they did, each to be taken once.
class RegistersByTrace {
 public:
  static constexpr std::size_t None = ~std::size_t{0};

  explicit RegistersByTrace(const NamedCircuit& named) {
    const auto traces = traces_of(named);
    for (std::size_t n = 0; n < traces.size(); ++n) by_trace_.emplace(traces[n], n);
  }
  std::size_t take(std::uint64_t trace) {
    const auto at = by_trace_.find(trace);
    if (at == by_trace_.end()) return None;
    const std::size_t n = at->second;
    by_trace_.erase(at);
    return n;
  }
  std::vector<std::size_t> left() const {
    std::vector<std::size_t> all;
    for (const auto& [trace, n] : by_trace_) all.push_back(n);
    return all;
  }

 private:
  std::multimap<std::uint64_t, std::size_t> by_trace_;
};

}  // namespace

std::vector<RegisterWord> words_as_in(const NamedCircuit& like, const NamedCircuit& circuit) {
  const auto known = traces_of(like);
  RegistersByTrace registers(circuit);
  std::vector<RegisterWord> found;
  for (const RegisterWord& word : like.words) {
    found.emplace_back();
    for (const std::size_t bit : word)
      if (const std::size_t n = registers.take(known[bit]); n != RegistersByTrace::None)
        found.back().push_back(n);
  }
  for (const std::size_t n : registers.left()) found.push_back({n});
  return found;
}

AndCircuit claims_as_in(const NamedCircuit& like, const NamedCircuit& circuit) {
  AndCircuit claims;
  claims.inputs = circuit.circuit.next.size();
  std::vector<Literal> values(like.circuit.inputs, False);
  for (const auto& [name, input] : like.inputs)
    if (reset_value(name.substr(0, name.find(' '))) == 0) values[input] = True;
  RegistersByTrace registers(circuit);
  for (const std::uint64_t trace : traces_of(like)) {
    const std::size_t n = registers.take(trace);
    if (n == RegistersByTrace::None) return claims;
    values.push_back(claims.input(n));
  }
  AndCircuit step = without_registers(like.circuit);
  step.outputs = step.failing;
  claims.outputs = claims.copy(step, values);
  return claims;
}

}  // namespace racebeam
