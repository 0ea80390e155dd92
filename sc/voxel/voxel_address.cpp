// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_address.h"

namespace racebeam {

voxel_address::voxel_address(const sc_core::sc_module_name& name, const voxel_knobs& k)
    : voxel_address_pins(name), core_(k) {
  SC_HAS_PROCESS(voxel_address);
  SC_METHOD(comb);
  sensitive << x_i << y_i << z_i << level_i;
}

void voxel_address::comb() {
  const voxel_place place =
      core_.comb(static_cast<int>(x_i.signed_value()), static_cast<int>(y_i.signed_value()),
                 static_cast<int>(z_i.signed_value()), level_i.value());
  word_o.drive(static_cast<int>(place.word));
  bit_o.drive(place.bit);
  inside_o.drive(place.inside);
}

}  // namespace racebeam
