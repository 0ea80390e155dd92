// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/state_values.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

#include "tb/signoff/always_zero.h"

namespace racebeam {

namespace {

constexpr std::size_t SmallWord = 6;  // bits; of wider ones each bit is looked at alone
constexpr int Runs = 8, Clocks = 64;
constexpr std::uint64_t Fold = 0x9e3779b97f4a7c15;  // of a trace to a number: odd, few patterns
constexpr int Seconds = 10;                         // for one question

using Lanes = std::uint64_t;

/// Of a random word the and, nothing or the or with two more: an eighth, a half, or more are 1.
Lanes random_lanes(std::mt19937_64& random, unsigned density) {
  const Lanes one = random();
  if (density == 0) return one & random() & random();
  return density == 1 ? one : one | random() | random();
}

/// Runs from the start with random inputs: the same ones each time for the same `inputs`.
template <class Each>
void run(const AndCircuit& circuit, const std::vector<std::size_t>& inputs, const Each& each) {
  std::mt19937_64 random(1);
  for (int run = 0; run < Runs; ++run) {
    CircuitLanes lanes(circuit);
    std::vector<unsigned> densities;
    for (std::size_t n = 0; n < inputs.size(); ++n)
      densities.push_back(static_cast<unsigned>(random() % 3));
    for (int clock = 0; clock < Clocks; ++clock) {
      for (std::size_t n = 0; n < inputs.size(); ++n)
        lanes.input(inputs[n]) = random_lanes(random, densities[n]);
      lanes.settle();
      each(lanes);
      lanes.clock();
    }
  }
}

/// What each register did, as one number.
std::vector<Lanes> traces_of(const NamedCircuit& named) {
  std::vector<std::size_t> inputs;
  for (const auto& [name, input] : named.inputs) inputs.push_back(input);
  std::vector<Lanes> traces(named.circuit.next.size());
  run(named.circuit, inputs, [&](const CircuitLanes& lanes) {
    for (std::size_t n = 0; n < traces.size(); ++n)
      traces[n] = (traces[n] ^ lanes.of(named.circuit.next[n])) * Fold;
  });
  return traces;
}

/// The registers of a circuit whose registers are its last inputs.
std::vector<Literal> state_inputs(const AndCircuit& step, std::size_t registers) {
  std::vector<Literal> state;
  for (std::size_t n = 0; n < registers; ++n)
    state.push_back(step.input(step.inputs - registers + n));
  return state;
}

}  // namespace

std::vector<RegisterWord> words_as_in(const NamedCircuit& like, const NamedCircuit& circuit) {
  const std::vector<Lanes> known = traces_of(like), traces = traces_of(circuit);
  std::multimap<Lanes, std::size_t> by_trace;
  for (std::size_t n = 0; n < traces.size(); ++n) by_trace.emplace(traces[n], n);
  std::vector<RegisterWord> found;
  for (const RegisterWord& word : like.words) {
    found.emplace_back();
    for (const std::size_t bit : word) {
      const auto at = by_trace.find(known[bit]);
      if (at == by_trace.end()) continue;
      found.back().push_back(at->second);
      by_trace.erase(at);
    }
  }
  for (const auto& [trace, n] : by_trace) found.push_back({n});
  return found;
}

StateValues::StateValues(const AndCircuit& circuit, const std::vector<RegisterWord>& words,
                         std::chrono::seconds limit) {
  for (const RegisterWord& word : words) {
    if (word.size() <= SmallWord) groups_.push_back({word, {0}});
    else
      for (const std::size_t bit : word) groups_.push_back({{bit}, {0}});
  }
  const auto end = std::chrono::steady_clock::now() + limit;
  run_a_while(circuit);
  if (close(circuit, end)) return;
  const auto wide = [](const Group& group) { return group.bits.size() == 1; };
  groups_.erase(std::remove_if(groups_.begin(), groups_.end(), wide), groups_.end());
  if (!close(circuit, end)) groups_.clear();
}

void StateValues::run_a_while(const AndCircuit& circuit) {
  std::vector<std::size_t> inputs(circuit.inputs);
  std::iota(inputs.begin(), inputs.end(), std::size_t{0});
  run(circuit, inputs, [&](const CircuitLanes& lanes) { take(circuit, lanes, ~Lanes{0}); });
  forget_free();
}

/// The next values in those lanes.
void StateValues::take(const AndCircuit& circuit, const CircuitLanes& lanes, Lanes which) {
  for (Group& group : groups_)
    for (int lane = 0; lane < 64; ++lane) {
      if (((which >> lane) & 1) == 0) continue;
      unsigned value = 0;
      for (std::size_t bit = 0; bit < group.bits.size(); ++bit)
        value |= static_cast<unsigned>((lanes.of(circuit.next[group.bits[bit]]) >> lane) & 1)
                 << bit;
      group.values.insert(value);
    }
}

/// Those of which any value is possible.
void StateValues::forget_free() {
  const auto free = [](const Group& group) {
    return group.values.size() == std::size_t{1} << group.bits.size();
  };
  groups_.erase(std::remove_if(groups_.begin(), groups_.end(), free), groups_.end());
}

/// One clock of a circuit, as without_registers() makes it, in which those registers are constants.
AndCircuit StateValues::one_clock(const AndCircuit& circuit) const {
  std::map<std::size_t, bool> tied;
  for (const auto& [at, value] : constants()) tied[circuit.inputs + at] = value;
  return with_constant_inputs(without_registers(circuit), tied);
}

/// Whether it is known that no clock leads out of the values.
bool StateValues::close(const AndCircuit& circuit, std::chrono::steady_clock::time_point end) {
  while (!groups_.empty()) {
    AndCircuit question = one_clock(circuit);
    const std::vector<Literal> next(
        question.outputs.begin(),
        question.outputs.begin() + static_cast<std::ptrdiff_t>(circuit.next.size()));
    const Literal before = hold(question, state_inputs(question, circuit.next.size()));
    question.outputs = {question.all(before, hold(question, next) ^ 1)};
    const auto [zero, inputs] = always_zero(question, std::chrono::seconds(Seconds));
    if (zero) return true;
    if (inputs.empty() || std::chrono::steady_clock::now() > end) return false;
    CircuitLanes lanes(circuit);
    for (std::size_t n = 0; n < inputs.size(); ++n)
      (n < circuit.inputs ? lanes.input(n) : lanes.register_at(n - circuit.inputs)) = inputs[n];
    lanes.settle();
    take(circuit, lanes, 1);
    forget_free();
  }
  return true;
}

std::map<std::size_t, bool> StateValues::constants() const {
  std::map<std::size_t, bool> constants;
  for (const Group& group : groups_)
    for (std::size_t bit = 0; bit < group.bits.size(); ++bit) {
      unsigned all = ~0u, any = 0;
      for (const unsigned value : group.values) all &= value, any |= value;
      if (((all ^ any) >> bit & 1) == 0) constants[group.bits[bit]] = (any >> bit & 1) != 0;
    }
  return constants;
}

void StateValues::choose(std::mt19937_64& random, std::vector<Lanes>& state) const {
  for (const Group& group : groups_) {
    const std::vector<unsigned> values(group.values.begin(), group.values.end());
    for (const std::size_t bit : group.bits) state[bit] = 0;
    for (int lane = 0; lane < 64; ++lane) {
      const unsigned value = values[random() % values.size()];
      for (std::size_t bit = 0; bit < group.bits.size(); ++bit)
        state[group.bits[bit]] |= Lanes{(value >> bit) & 1} << lane;
    }
  }
}

Literal StateValues::hold(AndCircuit& circuit, const std::vector<Literal>& state) const {
  Literal all = True;
  for (const Group& group : groups_) {
    Literal one = False;
    for (const unsigned value : group.values) {
      Literal is = True;
      for (std::size_t bit = 0; bit < group.bits.size(); ++bit)
        is = circuit.all(is, state[group.bits[bit]] ^ (((value >> bit) & 1) == 0 ? 1 : 0));
      one = circuit.any(one, is);
    }
    all = circuit.all(all, one);
  }
  return all;
}

}  // namespace racebeam
