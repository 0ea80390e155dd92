// Golden tracers of engines that have one, in a row each. The interval tracer has several, with
// causes: golden_compare.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tb/judge/golden_compare.h"
#include "tb/monitor/vga_monitor.h"

namespace racebeam {

/// Either can take every `step`th pixel of every `step`th line only.
struct GoldenKind {
  const racebeam::engine& engine;
  /// What a picture should be, of the chip's size and depth.
  VgaFrame (*picture)(const scene_tables* scene, const knob_values& k, int picture);
  /// Judges the chip's picture.
  PictureErrors (*compare)(const scene_tables* scene, const knob_values& k, int picture,
                           const PackedPicture& chip, int step);
};

const std::vector<GoldenKind>& goldens();

/// The row of an engine; nullptr: it has none.
const GoldenKind* golden_of(const engine& built);

}  // namespace racebeam
