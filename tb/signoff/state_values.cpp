// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/state_values.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <random>
#include <utility>

#include "tb/signoff/always_zero.h"
#include "tb/signoff/random_run.h"
#include "tb/signoff/value_bits.h"

namespace racebeam {

namespace {

constexpr std::size_t SmallWord = 6;  // bits; of wider ones each bit is looked at alone
constexpr int Parts = 6;              // of the time, for one question

using Lanes = std::uint64_t;

/// The registers of a circuit whose registers are its last inputs.
std::vector<Literal> state_inputs(const AndCircuit& step, std::size_t registers) {
  std::vector<Literal> state;
  for (std::size_t n = 0; n < registers; ++n)
    state.push_back(step.input(step.inputs - registers + n));
  return state;
}

/// The next values of the registers, the first outputs of such a circuit.
std::vector<Literal> next_in(const AndCircuit& step, std::size_t registers) {
  return {step.outputs.begin(), step.outputs.begin() + static_cast<std::ptrdiff_t>(registers)};
}

}  // namespace

StateValues::StateValues(const AndCircuit& circuit, const std::vector<RegisterWord>& words,
                         std::chrono::seconds limit, AndCircuit claims)
    : for_one_(std::max(limit / Parts, std::chrono::seconds(1))) {
  for (const RegisterWord& word : words) {
    if (word.size() <= SmallWord) groups_.push_back({word, {0}});
    else
      for (const std::size_t bit : word) groups_.push_back({{bit}, {0}});
  }
  const auto half = WorkClock::now() + limit / 2, end = half + limit / 2;
  run_a_while(circuit);
  const std::vector<Group> never_left = groups_;
  if (!close(circuit, half)) {
    const auto wide = [](const Group& group) { return group.bits.size() == 1; };
    groups_.erase(std::remove_if(groups_.begin(), groups_.end(), wide), groups_.end());
    if (!close(circuit, end)) close_each(circuit, end + limit / 2);
  }
  claims_ = std::move(claims);
  keep_proved(circuit, end);
  if (!claims_.outputs.empty()) add_claimed(never_left, end);
}

void StateValues::run_a_while(const AndCircuit& circuit) {
  std::vector<std::size_t> inputs(circuit.inputs);
  std::iota(inputs.begin(), inputs.end(), std::size_t{0});
  run_from_zero(circuit, inputs,
                [&](const CircuitLanes& lanes) { take(circuit, lanes, ~Lanes{0}); });
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
bool StateValues::close(const AndCircuit& circuit, WorkClock::time_point end) {
  while (!groups_.empty()) {
    AndCircuit question = one_clock(circuit);
    const std::vector<Literal> next = next_in(question, circuit.next.size());
    const Literal before = hold(question, state_inputs(question, circuit.next.size()));
    question.outputs = {question.all(before, hold(question, next) ^ 1)};
    const auto [zero, inputs] = always_zero(question, for_one_);
    if (zero) return true;
    if (inputs.empty() || WorkClock::now() > end) return false;
    take_found(circuit, inputs);
  }
  return true;
}

/// The next values of a clock that leads out of the values.
void StateValues::take_found(const AndCircuit& circuit, const std::vector<bool>& inputs) {
  CircuitLanes lanes(circuit);
  for (std::size_t n = 0; n < inputs.size(); ++n)
    (n < circuit.inputs ? lanes.input(n) : lanes.register_at(n - circuit.inputs)) = inputs[n];
  for (const auto& [at, value] : constants()) lanes.register_at(at) = value ? ~Lanes{0} : 0;
  lanes.settle();
  take(circuit, lanes, 1);
  forget_free();
}

/// Takes the groups one by one, and drops those of which it is not known.
void StateValues::close_each(const AndCircuit& circuit, WorkClock::time_point end) {
  for (std::size_t n = 0; n < groups_.size();) {
    AndCircuit question = one_clock(circuit);
    const std::vector<Literal> next = next_in(question, circuit.next.size());
    const Literal before = hold(question, state_inputs(question, circuit.next.size()));
    question.outputs = {question.all(before, holds(groups_[n], question, next) ^ 1)};
    if (WorkClock::now() > end) return groups_.clear();
    const auto [zero, inputs] = always_zero(question, for_one_);
    if (zero) {
      ++n;
      continue;
    }
    if (!inputs.empty()) take_found(circuit, inputs);
    else groups_.erase(groups_.begin() + static_cast<std::ptrdiff_t>(n));
    n = 0;  // the others may have needed it
  }
}

/// Drops the claims that are wrong at the start, and those that some clock leads out of.
void StateValues::keep_proved(const AndCircuit& circuit, WorkClock::time_point end) {
  auto& wrong = claims_.outputs;
  AndCircuit none;
  const auto at_start = none.copy(claims_, std::vector<Literal>(claims_.inputs, False));
  for (std::size_t n = wrong.size(); n-- > 0;)
    if (at_start[n] != False) wrong.erase(wrong.begin() + static_cast<std::ptrdiff_t>(n));
  for (std::size_t n = 0; n < wrong.size();) {
    AndCircuit question = one_clock(circuit);
    const std::vector<Literal> next = next_in(question, circuit.next.size());
    const Literal before = hold(question, state_inputs(question, circuit.next.size()));
    question.outputs = {question.all(before, question.copy(claims_, next)[n])};
    if (WorkClock::now() < end && always_zero(question, for_one_).zero) {
      ++n;
    } else {
      wrong.erase(wrong.begin() + static_cast<std::ptrdiff_t>(n));
      n = 0;  // the others may have needed it
    }
  }
}

/// Adds the groups that the claims imply: bits that never are 1, say, as a number is small.
void StateValues::add_claimed(const std::vector<Group>& groups, WorkClock::time_point end) {
  const std::vector<Group> known = groups_;
  for (const Group& group : groups) {
    const auto same = [&](const Group& one) { return one.bits == group.bits; };
    if (std::any_of(known.begin(), known.end(), same) || WorkClock::now() > end) continue;
    AndCircuit question;
    question.inputs = claims_.inputs;
    const std::vector<Literal> state = state_inputs(question, claims_.inputs);
    const Literal claimed = hold(question, state);
    groups_.push_back(group);
    question.outputs = {question.all(claimed, hold(question, state) ^ 1)};
    if (!always_zero(question, for_one_).zero) groups_.pop_back();
  }
}

std::map<std::size_t, bool> StateValues::constants() const {
  std::map<std::size_t, bool> constants;
  for (const Group& group : groups_) {
    const auto [all, any] = bits_of(group.values);
    for (std::size_t bit = 0; bit < group.bits.size(); ++bit)
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
  for (const Group& group : groups_) all = circuit.all(all, holds(group, circuit, state));
  return circuit.all(all, claimed(circuit, state));
}

Literal StateValues::holds(const Group& group, AndCircuit& circuit,
                           const std::vector<Literal>& state) {
  Literal one = False;
  for (const unsigned value : group.values) {
    Literal is = True;
    for (std::size_t bit = 0; bit < group.bits.size(); ++bit)
      is = circuit.all(is, state[group.bits[bit]] ^ (((value >> bit) & 1) == 0 ? 1 : 0));
    one = circuit.any(one, is);
  }
  return one;
}

Literal StateValues::claimed(AndCircuit& circuit, const std::vector<Literal>& state) const {
  Literal all = True;
  if (claims_.outputs.empty()) return all;
  const auto end = state.begin() + static_cast<std::ptrdiff_t>(claims_.inputs);
  for (const Literal wrong : circuit.copy(claims_, {state.begin(), end}))
    all = circuit.all(all, wrong ^ 1);
  return all;
}

Lanes StateValues::claimed(const std::vector<Lanes>& state) const {
  Lanes all = ~Lanes{0};
  if (claims_.outputs.empty()) return all;
  CircuitLanes lanes(claims_);
  for (std::size_t n = 0; n < claims_.inputs; ++n) lanes.input(n) = state[n];
  lanes.settle();
  for (const Literal wrong : claims_.outputs) all &= ~lanes.of(wrong);
  return all;
}

}  // namespace racebeam
