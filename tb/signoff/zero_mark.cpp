// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/zero_mark.h"

namespace racebeam {

AndCircuit with_zero_mark(AndCircuit circuit, const RegisterWord& word) {
  if (word.empty()) return circuit;
  const Literal gates = circuit.register_at(circuit.next.size());  // from there on
  const auto move = [gates](Literal& literal) {
    if (literal >= gates) literal += 2;
  };
  for (auto* list : {&circuit.next, &circuit.outputs, &circuit.failing})
    for (Literal& literal : *list) move(literal);
  for (auto& read : circuit.gates)
    for (Literal& literal : read) move(literal);
  circuit.next.push_back(False);
  Literal any = False;
  for (const std::size_t bit : word) any = circuit.any(any, circuit.next[bit]);
  circuit.next.back() = any;
  return circuit;
}

}  // namespace racebeam
