// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_parameters.h"

namespace racebeam {

std::vector<rtl_parameter> block_parameters(const block_knobs& k) {
  return {{"Lanes", k.lanes, "the knob lanes"},
          {"NewtonSteps", k.newton_steps, "the knob newton_steps"},
          {"SpecularSquarings", k.specular_squarings, "the knob specular_squarings"}};
}

}  // namespace racebeam
