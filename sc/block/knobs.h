// What an architect may change of the block renderer.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

struct block_knobs {
  int lanes = 4;               // spheres that a core looks at in a clock: 1, 2, 4, 8
  int newton_steps = 2;        // of an inverse root, 0..3
  int specular_squarings = 4;  // the highlight's power, 2^n, 0..6
};

}  // namespace racebeam
