// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/core_renderer.h"

#include "tb/bench/core_bench.h"

namespace racebeam {

GoldenPicture core_picture(int frame, const knobs& k, const scene_program* program) {
  return CoreBench(k, frame, program).picture();
}

}  // namespace racebeam
