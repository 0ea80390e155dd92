// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_lane.h"

namespace racebeam {

block_lane::block_lane(const sc_core::sc_module_name& name) : block_lane_pins(name) {
  SC_HAS_PROCESS(block_lane);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);
  sensitive << secondary_i << a_i.x << a_i.y << a_i.z << dir_i.x << dir_i.y << dir_i.z << k_i
            << clocked_;
}

block_lane_core::inputs block_lane::inputs() const {
  return {secondary_i.value() != 0, a_i.signed_value(), dir_i.signed_value(),
          static_cast<int>(k_i.signed_value())};
}

void block_lane::seq() {
  core_.clock(inputs());
  clocked_.notify(sc_core::SC_ZERO_TIME);
}

void block_lane::comb() {
  const auto o = core_.comb(inputs());
  b_o.drive(static_cast<std::uint64_t>(o.b));
  d_o.drive(static_cast<std::uint64_t>(o.d));
}

}  // namespace racebeam
