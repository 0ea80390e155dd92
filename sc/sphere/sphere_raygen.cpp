// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/sphere_raygen.h"

#include "sc/sphere/sphere_raygen_core.h"

namespace racebeam {

sphere_raygen::sphere_raygen(const sc_core::sc_module_name& name, const sphere_knobs& k)
    : sphere_raygen_pins(name), knobs_(k) {
  SC_HAS_PROCESS(sphere_raygen);
  SC_METHOD(comb);
  sensitive << x_i << y_i << sub_i << origin_i.x << origin_i.y << origin_i.z << screen_i
            << narrow_i;
}

void sphere_raygen::comb() {
  direction_o.drive(
      sphere_raygen_core::comb({x_i.value(), y_i.value(), sub_i.value(), origin_i.signed_value(),
                                screen_i.signed_value(), narrow_i.value() != 0},
                               knobs_));
}

}  // namespace racebeam
