// Whether a wide word of registers is not 0, as one more register of a circuit.
//
// A division by 0, say, is a state that no small word tells.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tb/signoff/aiger.h"
#include "tb/signoff/named_circuit.h"

namespace racebeam {

/// The circuit with one more register, the last one: the mark, 1 while that word is not 0. Without
/// a word, as it is.
AndCircuit with_zero_mark(AndCircuit circuit, const RegisterWord& word);

/// Whether the word is not 0 in a state, by lanes or literals.
template <class Bits>
typename Bits::Bit is_not_zero(Bits bits, const RegisterWord& word,
                               const std::vector<typename Bits::Bit>& state) {
  typename Bits::Bit any = Bits::No;
  for (const std::size_t bit : word) any = bits.any(any, state[bit]);
  return any;
}

}  // namespace racebeam
