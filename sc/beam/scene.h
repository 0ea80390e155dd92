// scene: the world as logic. Size and place of a room, and the room behind each of its faces.
//
// What    rooms on a 9 x 9 grid of 256 units; flags choose one of eight geometries (windows,
//         portals, blocked cells, heights, tunnel, narrow). R is the room's centre, S its half
//         size, neighbour the room through the face `axis`, towards negative coordinates where
//         signs has the axis' bit; all ones where the face is solid. edges tells which edges of the
//         face need no test by rays that come through it: they lie on or beyond the edges of the
//         room behind. Bit 0 is the edge towards positive coordinates of the axis two after the
//         face's (z, x, y for x, y, z), bit 1 that of the axis after, bits 2 and 3 those towards
//         negative ones; of no meaning where the face is solid, 0 unless the knob asks. A face has
//         one portal at most: look_portal_i and look_way_i have no effect, back is 0.
// Size    no registers. Room id {k(1), j(4), i(4)}, higher bits have no effect; coordinates
//         12 bits, modulo 4096.
// Cycles  combinational.
// Comb    all inputs -> all outputs (S and R do not depend on look_axis_i, look_signs_i).
// Stall   none.
// Reset   none.
// Knobs   skip_shared_edges: table has edges_o.
// Twin    rtl/beam/scene.sv
// Test    tests/beam/scene_test.cpp
// Source  contract sections 12 and 17.2; article "Scene structure".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/constants.h"
#include "sc/base/unit.h"
#include "sc/beam/codes.h"
#include "sc/beam/knobs.h"

namespace racebeam {

/// Behaviour of scene.
struct scene_core {
  struct room {
    vec3 half_size, position;
  };
  /// Half size and position (signed) of a room.
  static room geometry(int flags, int id);
  /// Room behind a face, SolidRoom if there is none.
  static int neighbour(int flags, int id, int axis, bool negative);
  /// edges_o; in the geometries of the demo.
  static int shared_edges(int flags, int id, int axis, bool negative);
};

/// Pins of scene and scene_rom.
class scene_pins : public sc_core::sc_module {
 public:
  // sequencer
  in_port<6> scene_flags_i{"scene_flags_i"};  // scene_flag bits
  // decision_datapath
  in_port<RoomPortBits> room_i{"room_i"};
  in_port<2> look_axis_i{"look_axis_i"};               // face looked through
  in_port<3> look_signs_i{"look_signs_i"};             // per axis, 1: towards negative coordinates
  in_port<PortalBits> look_portal_i{"look_portal_i"};  // of that face
  in_port<2> look_way_i{"look_way_i"};                 // look_way
  axes_out<CornerPortBits> half_size_o{"half_size", "_o"};
  axes_out<CornerPortBits> position_o{"position", "_o"};  // signed
  out_port<RoomPortBits> neighbour_o{"neighbour_o"};      // SolidRoom: none
  out_port<PortalBits> back_o{"back_o"};   // portal of the neighbour's face that leads back
  out_port<4> edges_o{"edges_o", OfKnob};  // of portal look_portal in the face: no test needed

  explicit scene_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The chip's scene.
class scene : public scene_pins {
 public:
  using pins = scene_pins;
  static constexpr const char* unit_name = "scene";

  scene(const sc_core::sc_module_name& name, const knobs& k);

 private:
  void comb();

  const bool has_edges_;
};

}  // namespace racebeam
