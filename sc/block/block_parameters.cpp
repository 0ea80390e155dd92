// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_parameters.h"

namespace racebeam {

std::vector<rtl_parameter> block_parameters(const block_knobs& k) {
  return {{"Cores", k.cores, "the knob cores"},
          {"Lanes", k.lanes, "the knob lanes"},
          {"MaxPasses", k.max_passes, "the knob max_passes"},
          {"Cull", k.cull, "the knob cull"},
          {"Background", k.background, "the knob background"},
          {"FractionBits", k.fraction_bits, "the knob fraction_bits"},
          {"PictureWidth", k.columns(), "the knob size"},
          {"PictureHeight", k.rows(), "the knob size"},
          {"NewtonSteps", k.newton_steps, "the knob newton_steps"},
          {"SpecularSquarings", k.specular_squarings, "the knob specular_squarings"}};
}

}  // namespace racebeam
