// The links of the chains by which errors are put down to causes: each lifts one limit of the chip,
// by knobs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/beam/knobs.h"

namespace racebeam {

struct ErrorCause {
  const char* name;     ///< as in the statistics file
  const char* meaning;  ///< what is lifted
};

struct ErrorLink {
  ErrorCause cause;
  /// Sets knobs so that the limit no longer counts; `standard` are the show's. nullptr: no knob
  /// does it, for the residues of the interlace.
  void (*lift)(knobs& k, const knobs& standard);
};

/// The highest value of a knob.
int most(int knobs::*member);

/// From the chip to trace_4 with the same knobs.
const std::vector<ErrorLink>& trace_4_links();
/// From the rays of trace_4 on: as far as knobs lead towards rays without rounding.
const std::vector<ErrorLink>& ray_links();

/// From the chip to trace_4 with the knobs of a reference picture, and as far as knobs lead to
/// geometry with those.
const std::vector<ErrorLink>& reference_trace_4_links();
const std::vector<ErrorLink>& reference_geometry_links();

}  // namespace racebeam
