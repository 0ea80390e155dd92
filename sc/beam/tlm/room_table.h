// room_table: the answers of scene as the rows that scene_rom serves.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/beam/scene.h"
#include "sc/beam/scene_program.h"

namespace racebeam {

/// All rooms of the built-in scenes with these flags, by the RoomBits low bits of their id.
inline std::vector<room_row> room_table(int flags) {
  std::vector<room_row> rooms(1 << RoomBits);
  for (int id = 0; id < 1 << RoomBits; ++id) {
    const auto room = scene_core::geometry(flags, id);
    rooms[id].half_size = room.half_size;
    rooms[id].position = room.position;
    for (int face = 0; face < 6; ++face) {
      const int axis = face / 2;
      const bool negative = face & 1;
      rooms[id].portals[face][0] = {
          static_cast<std::uint16_t>(scene_core::neighbour(flags, id, axis, negative)), 0,
          static_cast<std::uint8_t>(scene_core::shared_edges(flags, id, axis, negative))};
    }
  }
  return rooms;
}

}  // namespace racebeam
