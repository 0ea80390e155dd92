// Knobs drawn at random.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>

#include "sc/base/constants.h"
#include "sc/beam/knobs.h"

namespace racebeam {

/// Any setting of the built-in demo: each knob at its default, at one end or anywhere.
inline knobs random_knobs(int seed) {
  std::mt19937 random(seed);
  const auto below = [&](int count) { return static_cast<int>(random() % count); };
  knobs k;
  for (const knob_info& row : knob_table()) {
    if (row.of_scene) continue;
    const int max = row.member == &knobs::corner_bits ? CornerBits : row.max;
    if (below(3) == 0) k.*row.member = below(3) == 0 ? row.min : row.min + below(max - row.min + 1);
  }
  return k;
}

}  // namespace racebeam
