// scene_rom: the world as a table, for scene files; takes the place of scene, with the same pins.
//
// What    size, place and neighbours of each room are read from a scene_program. A face has up to
//         four portals; portal 0 is tried first. LookThrough answers the room behind a portal.
//         LookNext and LookPrevious are asked in the room behind a portal, with the face and the
//         portal that lead back: they answer the room behind the portal beside, in the order of
//         the face that was left. back_o is the portal that leads back from the room answered.
//         edges_o is of portal look_portal of the room asked in, whatever the way.
// Size    no registers; a row of the table has 6 x 16 bits of sizes and places, 24 x 15 bits of
//         portals, and 24 x 4 bits of edges for who skips shared ones.
// Cycles  combinational; LookNext and LookPrevious read the table twice.
// Comb    all inputs but scene_flags_i -> all outputs (S and R depend on room_i only).
// Stall   none.
// Reset   none. A room that the table does not have is of size 0, at 0, and solid.
// Twin    rtl/beam/scene_rom.sv
// Test    tests/beam/scene_rom_test.cpp
// Source  docs/scenes.md; article "Limitations" (several portals in one face).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/beam/scene.h"
#include "sc/beam/scene_program.h"

namespace racebeam {

/// Behaviour of scene_rom.
struct scene_rom_core {
  /// The row of a room; of none, an empty one.
  static const room_row& row(const std::vector<room_row>& rooms, int id) {
    static const room_row none;
    return id < static_cast<int>(rooms.size()) ? rooms[id] : none;
  }
  /// Half size and position of a room.
  static scene_core::room geometry(const scene_program& program, int id);
  /// What is behind a face, SolidRoom if nothing; with the edges of the portal asked about.
  static portal_row look(const std::vector<room_row>& rooms, int id, int axis, bool negative,
                         int portal, int way) {
    if (axis > 2) return {};
    const int face = 2 * axis + negative;
    const portal_row through = row(rooms, id).portals[face][portal];
    if (way == LookThrough) return through;
    const int beside = through.back + (way == LookNext ? 1 : -1);
    portal_row answer;
    if (beside >= 0 && beside < MaxPortals)
      answer = row(rooms, through.room).portals[face ^ 1][beside];
    answer.edges = through.edges;
    return answer;
  }
};

/// scene_rom with the table of a program, which must outlive it.
class scene_rom : public scene_pins {
 public:
  using pins = scene_pins;
  static constexpr const char* unit_name = "scene_rom";

  scene_rom(const sc_core::sc_module_name& name, const scene_program& program);

 private:
  void comb();

  const scene_program& program_;
};

}  // namespace racebeam
