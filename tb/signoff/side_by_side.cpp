// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/side_by_side.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>

#include "tb/signoff/always_zero.h"

namespace racebeam {

namespace {

constexpr std::chrono::seconds ForOne{2};  // gate

/// 64 values of each variable of a growing circuit without registers, several times.
class Samples {
 public:
  explicit Samples(const AndCircuit& circuit) : circuit_(circuit), values_(1 + circuit.inputs) {
    for (std::size_t n = 1; n < values_.size(); ++n)
      for (Lanes& word : values_[n]) word = random_();
  }

  bool same(Literal a, Literal b) {
    while (values_.size() <= circuit_.inputs + circuit_.gates.size()) {
      values_.emplace_back();
      for (std::size_t word = 0; word < Words; ++word) settle(values_.size() - 1, word);
    }
    for (std::size_t word = 0; word < Words; ++word)
      if (of(a, word) != of(b, word)) return false;
    return true;
  }

  /// In place of others: those values of the inputs, and around them.
  void take(const std::vector<bool>& inputs) {
    const std::size_t word = next_;
    next_ = next_ + 1 < Words ? next_ + 1 : Random;
    for (std::size_t n = 0; n < inputs.size(); ++n)
      values_[1 + n][word] =
          (inputs[n] ? ~Lanes{0} : 0) ^ (random_() & random_() & random_() & ~Lanes{1});
    for (std::size_t n = 1 + inputs.size(); n < values_.size(); ++n) settle(n, word);
  }

 private:
  using Lanes = std::uint64_t;
  static constexpr std::size_t Words = 32, Random = 16;  // words that stay random

  Lanes of(Literal literal, std::size_t word) const {
    return values_[literal / 2][word] ^ ((literal & 1) != 0 ? ~Lanes{0} : 0);
  }
  void settle(std::size_t variable, std::size_t word) {
    const auto& [a, b] = circuit_.gates[variable - 1 - circuit_.inputs];
    values_[variable][word] = of(a, word) & of(b, word);
  }

  const AndCircuit& circuit_;
  std::vector<std::array<Lanes, Words>> values_;  // by variable
  std::mt19937_64 random_{1};
  std::size_t next_ = Random;
};

/// What is 1 where two literals differ, with the gates that it needs.
AndCircuit difference_of(const AndCircuit& circuit, Literal a, Literal b) {
  AndCircuit one = cone_of(circuit, {a, b});
  const Literal is_a = one.outputs[0], is_b = one.outputs[1];
  one.outputs = {one.differ(is_a, is_b)};
  return one;
}

Literal value_of(const std::vector<Literal>& known, Literal literal) {
  return known[literal / 2] ^ (literal & 1);
}

/// The gates of two circuits, of as many gates, through which all differences of outputs go, by
/// their variables. `was` and `is` are the values of those, one literal if they are known to be
/// equal.
std::vector<std::size_t> gates_of_all_differences(const AndCircuit& unit, const AndCircuit& mutant,
                                                  const std::vector<Literal>& was,
                                                  const std::vector<Literal>& is) {
  const std::size_t end = was.size(), first = 1 + unit.inputs;
  std::vector<bool> differs(end);      // and some output shows it
  std::vector<std::size_t> last(end);  // that reads a difference; `end` is an output
  std::size_t furthest = 0;            // of what differences begin at, or have come to
  const auto reads = [&](std::size_t reader, Literal was_read, Literal is_read) {
    if (was_read != is_read) furthest = std::max(furthest, reader);
    for (const Literal read : {was_read, is_read}) {
      if (was[read / 2] == is[read / 2]) continue;
      differs[read / 2] = true;
      last[read / 2] = std::max(last[read / 2], reader);
    }
  };
  for (std::size_t n = 0; n < unit.outputs.size(); ++n)
    if (value_of(was, unit.outputs[n]) != value_of(is, mutant.outputs[n]))
      reads(end, unit.outputs[n], mutant.outputs[n]);
  for (std::size_t at = end; at-- > first;)
    for (std::size_t side = 0; differs[at] && side < 2; ++side)
      reads(at, unit.gates[at - first][side], mutant.gates[at - first][side]);
  std::vector<std::size_t> found;
  for (std::size_t at = 0; at < end; ++at) {
    if (!differs[at]) continue;
    if (at >= first && furthest <= at) found.push_back(at);
    furthest = std::max(furthest, last[at]);
  }
  return found;
}

}  // namespace

SideBySide copy_side_by_side(AndCircuit& into, const AndCircuit& unit, const AndCircuit& mutant,
                             const std::vector<Literal>& unit_values,
                             const std::vector<Literal>& mutant_values, WorkClock::time_point end) {
  if (unit.gates.size() != mutant.gates.size())
    return {into.copy(unit, unit_values), into.copy(mutant, mutant_values), {}};
  Samples samples(into);
  std::vector<Literal> was{False}, is{False};  // by variable
  was.insert(was.end(), unit_values.begin(), unit_values.end());
  is.insert(is.end(), mutant_values.begin(), mutant_values.end());
  for (std::size_t n = 0; n < unit.gates.size(); ++n) {
    const auto& [was_a, was_b] = unit.gates[n];
    const auto& [is_a, is_b] = mutant.gates[n];
    const std::array was_read{value_of(was, was_a), value_of(was, was_b)};
    const std::array is_read{value_of(is, is_a), value_of(is, is_b)};
    was.push_back(into.all(was_read[0], was_read[1]));
    Literal gate = is_read == was_read ? was.back() : into.all(is_read[0], is_read[1]);
    if (gate != was.back() && WorkClock::now() < end && samples.same(gate, was.back())) {
      const ZeroAnswer answer = always_zero(difference_of(into, gate, was.back()), ForOne);
      if (answer.zero) gate = was.back();
      else if (!answer.inputs.empty()) samples.take(answer.inputs);
    }
    is.push_back(gate);
  }
  SideBySide both;
  for (const Literal output : unit.outputs) both.unit.push_back(value_of(was, output));
  for (const Literal output : mutant.outputs) both.mutant.push_back(value_of(is, output));
  for (const std::size_t at : gates_of_all_differences(unit, mutant, was, is))
    both.changed.push_back(into.differ(was[at], is[at]));
  return both;
}

}  // namespace racebeam
