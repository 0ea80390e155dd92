// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/step_question.h"

#include <map>

#include "tb/signoff/side_by_side.h"
#include "tb/signoff/value_bits.h"
#include "tb/signoff/zero_mark.h"

namespace racebeam {

namespace {

using Literals = std::vector<Literal>;

/// Which registers count after the clock: literals, of those that are free in the same states one.
/// It is asked first whether a clock leads to other states at all, so that nobody looks for a
/// difference behind a multiplier that would not count.
Literals counting(AndCircuit& circuit, const ReachedPairs& reached, const Literals& unit,
                  const Literals& mutant, std::size_t registers, Literal before) {
  std::map<std::vector<unsigned>, Literal> known{{{}, True}};
  Literals counts;
  for (std::size_t n = 0; n < registers; ++n) {
    counts.push_back(False);
    if (unit[n] == mutant[n]) continue;
    std::vector<unsigned> states;
    for (const auto& [value, where] : reached.by_value())
      if (where.free[n]) states.push_back(value);
    const auto [at, is_new] = known.try_emplace(states, True);
    if (is_new) {
      for (const unsigned value : states)
        at->second = circuit.all(at->second, reached.is(CircuitBits{circuit}, unit, value) ^ 1);
      circuit.outputs = {circuit.all(before, at->second)};
      if (zero_at_once(circuit).zero) at->second = False;
    }
    counts.back() = at->second;
  }
  return counts;
}

/// Whether a clock leads out of what is known; of each the next values of registers, and outputs.
Literal leads_out(AndCircuit& circuit, const ReachedPairs& reached, const Literals& unit,
                  const Literals& mutant, const Literals& counts) {
  const CircuitBits bits{circuit};
  Literal out = True;
  for (const auto& [v, m] : reached.pairs())
    out = circuit.all(out, circuit.all(reached.is(bits, unit, v), reached.is(bits, mutant, m)) ^ 1);
  for (std::size_t n = 0; n < unit.size(); ++n) {
    if (n < counts.size() && reached.in_word(n)) continue;
    const Literal here = n < counts.size() ? counts[n] : True;
    out = circuit.any(out, circuit.all(here, circuit.differ(unit[n], mutant[n])));
  }
  return out;
}

/// A circuit whose first output is 1 if a clock leads out of what is known; if any other one is 0
/// for all inputs, so is that.
AndCircuit circuit_of(const StepQuestion& of, unsigned value, WorkClock::time_point swept_until) {
  const ReachedPairs& reached = of.reached;
  const RegisterWord& word = reached.word();
  AndCircuit circuit;
  const std::size_t registers = of.unit.next.size();
  circuit.inputs = of.unit.inputs + 2 * registers;
  const CircuitBits bits{circuit};
  Literals inputs, state, any;
  for (std::size_t n = 0; n < of.unit.inputs; ++n) inputs.push_back(circuit.input(n));
  for (std::size_t n = 0; n < registers; ++n) {
    state.push_back(circuit.input(of.unit.inputs + n));
    any.push_back(circuit.input(of.unit.inputs + registers + n));
  }
  for (const auto& [at, one] : of.possible.constants()) state[at] = one ? True : False;
  const std::set<unsigned>& others = reached.by_value().at(value).mutant;
  const auto [least, most] = bits_of(others);
  for (std::size_t bit = 0; bit < word.size(); ++bit) {
    state[word[bit]] = ((value >> bit) & 1) != 0 ? True : False;
    if (((least ^ most) >> bit & 1) == 0) any[word[bit]] = ((least >> bit) & 1) != 0 ? True : False;
  }
  Literal is_possible = of.possible.hold(circuit, state);
  if (!of.wide.empty()) {
    const Literal mark = is_not_zero(bits, of.wide, state);
    is_possible = circuit.all(is_possible, state.back() == True ? mark : mark ^ 1);
  }
  for (std::size_t n = 0; n < registers; ++n)
    if (!reached.in_word(n)) state[n] = circuit.all(is_possible, state[n]);
  Literals from = inputs, beside = inputs;
  const Literals other_state = reached.beside(bits, state, any);
  from.insert(from.end(), state.begin(), state.end());
  beside.insert(beside.end(), other_state.begin(), other_state.end());
  const auto [unit, mutant, changed] = copy_side_by_side(
      circuit, without_registers(of.unit), without_registers(of.mutant), from, beside, swept_until);
  Literal is_other = False;
  for (const unsigned other : others)
    is_other = circuit.any(is_other, reached.is(bits, any, other));
  const Literal before = circuit.all(is_other, is_possible);
  const Literals counts = counting(circuit, reached, unit, mutant, registers, before);
  const auto out = [&](const Literals& beside_unit) {
    return leads_out(circuit, reached, unit, beside_unit, counts);
  };
  const Literal unit_alone = circuit.all(before, out(unit));
  circuit.outputs = {unit_alone};
  const bool by_difference = zero_at_once(circuit).zero;  // a clock leads out, if it does
  Literal both = circuit.all(before, out(mutant));
  std::vector<Literal> enough;
  for (const Literal one : changed) {
    if (!by_difference) break;
    both = circuit.all(both, one);  // it follows, and helps to decide
    enough.push_back(circuit.all(before, one));
  }
  circuit.outputs = {both};
  circuit.outputs.insert(circuit.outputs.end(), enough.begin(), enough.end());
  return circuit;
}

}  // namespace

ZeroAnswer StepQuestion::ask(unsigned value, WorkClock::time_point swept_until,
                             std::chrono::seconds limit) const {
  AndCircuit circuit = circuit_of(*this, value, swept_until);
  const Literals outputs = circuit.outputs;
  for (std::size_t n = 1; n < outputs.size(); ++n) {
    circuit.outputs = {outputs[n]};
    if (zero_at_once(circuit).zero) return {true, {}};
  }
  circuit.outputs = {outputs[0]};
  return limit.count() == 0 ? zero_at_once(circuit) : always_zero(circuit, limit);
}

}  // namespace racebeam
