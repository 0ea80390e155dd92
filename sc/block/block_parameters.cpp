// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_parameters.h"

#include "sc/store/store_parameters.h"

namespace racebeam {

std::vector<rtl_parameter> block_parameters(const block_knobs& k) {
  std::vector<rtl_parameter> all = store_parameters(k.store());
  const std::vector<rtl_parameter> own = {
      {"Cores", k.cores, "the knob cores"},
      {"Lanes", k.lanes, "the knob lanes"},
      {"MaxPasses", k.max_passes, "the knob max_passes"},
      {"Root", k.root, "the knob root"},
      {"ShadowRays", k.shadow_rays, "the knob shadow_rays"},
      {"Cull", k.cull, "the knob cull"},
      {"Background", k.background, "the knob background"},
      {"FractionBits", k.fraction_bits, "the knob fraction_bits"},
      {"NewtonSteps", k.newton_steps, "the knob newton_steps"},
      {"SpecularSquarings", k.specular_squarings, "the knob specular_squarings"}};
  all.insert(all.end(), own.begin(), own.end());
  return all;
}

}  // namespace racebeam
