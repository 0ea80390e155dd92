// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/sphere_picture.h"

namespace racebeam {

std::vector<sphere_row> spheres_of(const SphereProgram& program, const sphere_knobs& k,
                                   int picture) {
  SphereMotion motion(program.moving, program.box, k.capture_guard);
  for (int n = 1; n <= picture; ++n) motion.picture(program.inputs_before(n).rotz_q);
  return motion.table();
}

std::unique_ptr<sphere_core> core_before(const SphereProgram& program, const sphere_knobs& k,
                                         int picture) {
  auto core = std::make_unique<sphere_core>(k, program, program.board);
  core->deposit(program.inputs_before(picture));
  core->load(spheres_of(program, k, picture));
  return core;
}

}  // namespace racebeam
