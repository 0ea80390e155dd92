// What `racebeam compare` needs of an engine besides its tables, in a row for each.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "tb/base/spread.h"
#include "tb/judge/hit_maps.h"

namespace racebeam {

struct CompareKind {
  const racebeam::engine& engine;
  /// Adds the clocks that each pixel took, or each line of an engine that races the beam.
  void (*add_costs)(const Show& show, const knob_values& k, const ChipBench::Frame& frame,
                    Spread& costs);
  int sample_pixels;  ///< pixels that such clocks are of
};

const std::vector<CompareKind>& compare_kinds();

/// The row of an engine. Throws std::out_of_range.
const CompareKind& compare_kind_of(const engine& built);

/// A picture by the engine's golden tracer that knows nothing of its arithmetic; nullopt: it has
/// none.
std::optional<VgaFrame> ideal_picture(const Show& show, const knob_values& k, int picture);

}  // namespace racebeam
