// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/state_values.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "tb/signoff/random_run.h"

namespace racebeam {

namespace {

constexpr int Parts = 6;          // of the time, for one question
constexpr int Quiet = 32;         // runs in which nothing new comes
constexpr std::size_t Apart = 8;  // clocks, states that are kept

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

/// Which registers what is told by the outputs of a circuit depends on, of one whose inputs they
/// are.
std::vector<bool> registers_read(const AndCircuit& circuit) {
  const AndCircuit cone = cone_of(circuit, circuit.outputs);
  std::vector<bool> read(1 + cone.inputs + cone.gates.size());
  for (const Literal output : cone.outputs) read[output / 2] = true;
  for (const auto& gate : cone.gates)
    for (const Literal literal : gate) read[literal / 2] = true;
  return {read.begin() + 1, read.begin() + 1 + static_cast<std::ptrdiff_t>(cone.inputs)};
}

}  // namespace

StateValues::StateValues(const AndCircuit& circuit, const std::vector<RegisterWord>& words,
                         std::chrono::seconds limit, AndCircuit claims)
    : for_one_(std::max(limit / Parts, std::chrono::seconds(1))), groups_(words) {
  const auto begin = WorkClock::now();
  run_a_while(circuit);
  const ValueGroups never_left = groups_;
  run_from_any(circuit);
  if (!close(circuit, begin + limit)) {
    groups_.drop_bits();
    if (!close(circuit, begin + 2 * limit)) groups_ = {};
  }
  claims_ = std::move(claims);
  const auto end = WorkClock::now() + limit;
  keep_proved(circuit, end);
  if (!claims_.outputs.empty()) add_claimed(never_left, end);
}

void StateValues::run_a_while(const AndCircuit& circuit) {
  std::vector<std::size_t> inputs(circuit.inputs);
  std::iota(inputs.begin(), inputs.end(), std::size_t{0});
  std::size_t clock = 0;
  run_from_zero(circuit, inputs, [&](const CircuitLanes& lanes) {
    groups_.take(circuit, lanes, ~Lanes{0});
    if (++clock % Apart != 0) return;
    seen_.emplace_back();
    for (const Literal next : circuit.next) seen_.back().push_back(lanes.of(next));
  });
}

/// The next values of states at random that have the values, as long as some are new.
void StateValues::run_from_any(const AndCircuit& circuit) {
  std::mt19937_64 random(1);
  CircuitLanes lanes(circuit);
  std::vector<Lanes> state(circuit.next.size());
  for (int quiet = 0; quiet < Quiet && !groups_.all().empty(); ++quiet) {
    for (std::size_t n = 0; n < circuit.inputs; ++n) lanes.input(n) = random();
    for (Lanes& one : state) one = random();
    groups_.choose(random, state);
    for (std::size_t n = 0; n < state.size(); ++n) lanes.register_at(n) = state[n];
    lanes.settle();
    if (groups_.take(circuit, lanes, ~Lanes{0})) quiet = 0;
  }
}

/// One clock of a circuit, as without_registers() makes it, in which those registers are constants.
AndCircuit StateValues::one_clock(const AndCircuit& circuit) const {
  std::map<std::size_t, bool> tied;
  for (const auto& [at, value] : constants()) tied[circuit.inputs + at] = value;
  return with_constant_inputs(without_registers(circuit), tied);
}

/// Takes in values, and drops groups of which it is not known, until no clock leads out of those of
/// any group; false if the time is over before.
bool StateValues::close(const AndCircuit& circuit, WorkClock::time_point end) {
  std::size_t some = groups_.all().size();  // that are asked of at once
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t n = 0; n < groups_.all().size();) {
      if (WorkClock::now() > end) return false;
      some = std::min(some, groups_.all().size() - n);
      const auto [zero, inputs] = leads_out(circuit, n, some);
      if (zero) {
        n += some;
        some *= 2;
        continue;
      }
      changed |= !inputs.empty() || some == 1;
      if (!inputs.empty()) take_found(circuit, inputs);
      else if (some == 1) groups_.drop(n);
      else some /= 2;
    }
  }
  return true;
}

/// Whether a clock leads out of the values of some groups, from that one on, if all have theirs.
ZeroAnswer StateValues::leads_out(const AndCircuit& circuit, std::size_t first,
                                  std::size_t count) const {
  AndCircuit question = one_clock(circuit);
  const std::vector<Literal> next = next_in(question, circuit.next.size());
  const Literal before = hold(question, state_inputs(question, circuit.next.size()));
  const Literal after = groups_.hold(question, next, first, count);
  question.outputs = {question.all(before, after ^ 1)};
  return count == 1 ? always_zero(question, for_one_) : zero_at_once(question);
}

/// The next values of a clock that leads out of the values, and of what follows.
void StateValues::take_found(const AndCircuit& circuit, const std::vector<bool>& inputs) {
  CircuitLanes lanes(circuit);
  for (std::size_t n = 0; n < inputs.size(); ++n)
    (n < circuit.inputs ? lanes.input(n) : lanes.register_at(n - circuit.inputs)) = inputs[n];
  for (const auto& [at, value] : constants()) lanes.register_at(at) = value ? ~Lanes{0} : 0;
  lanes.settle();
  groups_.take(circuit, lanes, 1);
  run_from_any(circuit);
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
void StateValues::add_claimed(const ValueGroups& groups, WorkClock::time_point end) {
  const std::vector<ValueGroups::Group> known = groups_.all();
  const std::vector<bool> read = registers_read(claims_);
  for (const ValueGroups::Group& group : groups.all()) {
    const auto same = [&](const ValueGroups::Group& one) { return one.bits == group.bits; };
    const auto is_read = [&](std::size_t bit) { return read[bit]; };
    if (std::none_of(group.bits.begin(), group.bits.end(), is_read) ||
        std::any_of(known.begin(), known.end(), same) || WorkClock::now() > end)
      continue;
    AndCircuit question;
    question.inputs = claims_.inputs;
    const std::vector<Literal> state = state_inputs(question, claims_.inputs);
    const Literal claimed = hold(question, state);
    groups_.add(group);
    question.outputs = {question.all(claimed, hold(question, state) ^ 1)};
    if (!always_zero(question, for_one_).zero) groups_.drop_last();
  }
}

Literal StateValues::hold(AndCircuit& circuit, const std::vector<Literal>& state) const {
  return circuit.all(groups_.hold(circuit, state), claimed(circuit, state));
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
