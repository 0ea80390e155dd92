// The chip with its limits switched off: what then is left is the interval tracer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/beam/knobs.h"

namespace racebeam {

/// No cut, shift, hurry, stack limit, beam, or residues of the interlace.
inline knobs unlimited(knobs k = {}) {
  k.partial_products_cut = 0;
  k.corner_factor_bits = 16;
  k.hurry_threshold = -1;
  k.interval_stack_depth = 64;
  k.fifo_entries = 64;
  k.clocks_per_pixel = 8;
  k.interlace = 0;
  return k;
}

}  // namespace racebeam
