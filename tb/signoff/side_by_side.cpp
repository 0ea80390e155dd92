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
  one.outputs = {one.any(one.all(is_a, is_b ^ 1), one.all(is_a ^ 1, is_b))};
  return one;
}

}  // namespace

SideBySide copy_side_by_side(AndCircuit& into, const AndCircuit& unit, const AndCircuit& mutant,
                             const std::vector<Literal>& unit_values,
                             const std::vector<Literal>& mutant_values, WorkClock::time_point end) {
  if (unit.gates.size() != mutant.gates.size())
    return {into.copy(unit, unit_values), into.copy(mutant, mutant_values)};
  Samples samples(into);
  std::vector<Literal> was{False}, is{False};  // by variable
  was.insert(was.end(), unit_values.begin(), unit_values.end());
  is.insert(is.end(), mutant_values.begin(), mutant_values.end());
  const auto in = [](const std::vector<Literal>& known, Literal literal) {
    return known[literal / 2] ^ (literal & 1);
  };
  for (std::size_t n = 0; n < unit.gates.size(); ++n) {
    const std::array was_read{in(was, unit.gates[n][0]), in(was, unit.gates[n][1])};
    const std::array is_read{in(is, mutant.gates[n][0]), in(is, mutant.gates[n][1])};
    was.push_back(into.all(was_read[0], was_read[1]));
    Literal gate = is_read == was_read ? was.back() : into.all(is_read[0], is_read[1]);
    if (gate != was.back() && WorkClock::now() < end && samples.same(gate, was.back())) {
      const ZeroAnswer answer = always_zero(difference_of(into, gate, was.back()), ForOne);
      if (answer.zero) gate = was.back();
      else if (!answer.inputs.empty()) samples.take(answer.inputs);
    }
    is.push_back(gate);
  }
  SideBySide outputs;
  for (const Literal output : unit.outputs) outputs.unit.push_back(in(was, output));
  for (const Literal output : mutant.outputs) outputs.mutant.push_back(in(is, output));
  return outputs;
}

}  // namespace racebeam
