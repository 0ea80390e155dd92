// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_root.h"

#include "sc/block/numbers.h"

namespace racebeam {

block_root::block_root(const sc_core::sc_module_name& name) : block_root_pins(name) {
  SC_HAS_PROCESS(block_root);
  SC_METHOD(comb);
  sensitive << d_i;
}

void block_root::comb() { root_o.drive(isqrt(d_i.value())); }

}  // namespace racebeam
