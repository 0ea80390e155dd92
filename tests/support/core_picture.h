// Pictures of the chip's cores in one loop: what the faster ones are held to.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/bench/core_bench.h"
#include "tb/golden/golden_picture.h"

namespace racebeam {

/// One frame of the demo, 0..12798, or of a program that fits the knobs, as the chip with these
/// knobs shows it: sampled as a monitor does, in the last clock of each column, from a chip that
/// starts in reset just before the frame.
inline GoldenPicture core_picture(int frame, const knobs& k,
                                  const scene_program* program = nullptr) {
  return CoreBench(k, frame, program).picture();
}

}  // namespace racebeam
