// What may tell in which state a unit is, where some of its registers do not count.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tb/signoff/aiger.h"
#include "tb/signoff/named_circuit.h"

namespace racebeam {

/// The value of a small word, and whether a wide one is 0; either may be empty.
struct StateTold {
  RegisterWord word, wide;
};

/// No word first, then one small one after the other, a state that many read before others, then
/// two; then with a wide one, such as a denominator on which most depends.
std::vector<StateTold> ways_to_tell(const AndCircuit& circuit,
                                    const std::vector<RegisterWord>& words);

}  // namespace racebeam
