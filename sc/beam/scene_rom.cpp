// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/scene_rom.h"

namespace racebeam {

scene_core::room scene_rom_core::geometry(const scene_program& program, int id) {
  const room_row& room = row(program.rooms, id);
  return {room.half_size, room.position};
}

scene_rom::scene_rom(const sc_core::sc_module_name& name, const scene_program& program)
    : scene_pins(name), program_(program) {
  SC_HAS_PROCESS(scene_rom);
  SC_METHOD(comb);
  sensitive << room_i << look_axis_i << look_signs_i << look_portal_i << look_way_i;
}

void scene_rom::comb() {
  const int id = room_i.value(), axis = look_axis_i.value();
  const auto room = scene_rom_core::geometry(program_, id);
  const auto beyond =
      scene_rom_core::look(program_.rooms, id, axis, bit_of(look_signs_i.value(), axis),
                           look_portal_i.value(), look_way_i.value());
  half_size_o.drive(room.half_size);
  position_o.drive(room.position);
  neighbour_o.drive(beyond.room);
  back_o.drive(beyond.back);
  edges_o.drive(beyond.edges);
}

}  // namespace racebeam
