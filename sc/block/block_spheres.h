// block_spheres: the spheres of one lane.
//
// What    write_i writes one field of an entry at the end of the clock. A centre's field writes
//         pose = eye - centre of that axis too: eye_k_i is the eye's component. Of the fields
//         above BlockRv BlockRadius2 alone is written. Lane n of a core has the spheres
//         n, n + lanes, ... in the entries 0, 1, ...; of an index the bits above the entries do not
//         count.
// Size    64 / lanes entries of 384 bits; without cull = cone nothing reads the radius: 352.
// Cycles  a write is read from the next clock on.
// Comb    group_i -> all outputs.
// Stall   none.
// Reset   none.
// Knobs   lanes, 1, 2, 4, 8: parameter Lanes.
// Twin    rtl/block/block_spheres.sv
// Test    tests/block/block_spheres_test.cpp
// Source  article "The Integer Raytracer".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/block/block_spheres_core.h"
#include "sc/block/codes.h"
#include "sc/block/knobs.h"

namespace racebeam {

/// Pins of block_spheres.
class block_spheres_pins : public sc_core::sc_module {
 public:
  // Clock
  in_port<1> clk_i{"clk_i"};
  // block_convert
  in_port<1> write_i{"write_i"};
  in_port<BlockFieldBits> field_i{"field_i"};  // block_field
  in_port<BlockIndexBits> index_i{"index_i"};  // in this lane
  in_port<BlockBits> value_i{"value_i"};       // signed
  in_port<BlockBits> eye_k_i{"eye_k_i"};       // signed, of the axis of a centre
  // block_core
  in_port<BlockIndexBits> group_i{"group_i"};
  axes_out<BlockBits> pose_o{"pose", "_o"};      // signed, from the centre to the eye
  out_port<BlockBits> rv_o{"rv_o"};              // signed, radius2 - pose^2
  axes_out<BlockBits> centre_o{"centre", "_o"};  // signed
  out_port<BlockBits> radius_o{"radius_o"};
  out_port<BlockBits> radius2_o{"radius2_o"};
  out_port<BlockBits> red_o{"red_o"};
  out_port<BlockBits> green_o{"green_o"};
  out_port<BlockBits> blue_o{"blue_o"};

  explicit block_spheres_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of block_spheres: its core behind the pins.
class block_spheres : public block_spheres_pins, public probed {
 public:
  using pins = block_spheres_pins;
  static constexpr const char* unit_name = "block_spheres";

  block_spheres(const sc_core::sc_module_name& name, const block_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }

 private:
  void seq();
  void comb();

  const block_knobs knobs_;
  block_spheres_core core_;
  sc_core::sc_event written_{"written"};
};

}  // namespace racebeam
