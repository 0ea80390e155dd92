// The block renderer's pictures beside those in double precision: a row of goldens().
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/host/block_program.h"
#include "tb/judge/golden_compare.h"
#include "tb/monitor/vga_monitor.h"

namespace racebeam {

/// Of 256 levels a channel; the bounds of the design are for two of them.
struct BlockErrors {
  PictureErrors all;
  std::uint64_t by_more_than_2 = 0, by_more_than_16 = 0;  ///< pixels, in some channel
};

/// What the cores' rays of all pixels meet first, row by row: a sphere, or -1.
std::vector<int> block_first_hits(const block_tables& tables, block_knobs k);

/// As GoldenKind has them. `scene`: a BlockProgram, or nullptr: the scene that is built in.
VgaFrame block_golden_picture(const scene_tables* scene, const knob_values& k, int picture);
PictureErrors block_golden_errors(const scene_tables* scene, const knob_values& k, int picture,
                                  const PackedPicture& chip, int step);
/// The same by what the host sent; what is under the load bar is not looked at.
BlockErrors block_errors(const block_tables& tables, const block_knobs& k,
                         const PackedPicture& chip, int step);

}  // namespace racebeam
