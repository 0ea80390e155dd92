// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/scene_compiler.h"

#include <algorithm>

#include "tb/scene/scene_check.h"

namespace racebeam {

namespace {

int place_of(int room, const std::vector<int>& portals) {
  return static_cast<int>(std::find(portals.begin(), portals.end(), room) - portals.begin());
}

/// Edges of a room's face on or beyond those of the room behind (sc/beam/scene.h, edges_o), with
/// differences as `bits` of a corner hold them.
int shared_edges(const Room& here, const Room& behind, int axis, int bits) {
  int edges = 0;
  for (int edge = 0; edge < 4; ++edge) {
    const int a = (axis + (edge & 1 ? 1 : 2)) % 3, side = edge < 2 ? 1 : -1;
    const int beyond =
        side * (here.centre[a] - behind.centre[a]) + here.half_size[a] - behind.half_size[a];
    if (wrap_signed(beyond, bits) >= 0) edges |= 1 << edge;
  }
  return edges;
}

room_row compile_room(const SceneFile& scene, int number, int corner_bits) {
  const Room& room = scene.rooms[number];
  room_row row;
  row.half_size = room.half_size;
  row.position = room.centre;
  for (int face = 0; face < FaceCount; ++face)
    for (std::size_t i = 0; i < room.portals[face].size(); ++i) {
      const int beyond = room.portals[face][i];
      const int back = place_of(number, scene.rooms[beyond].portals[opposite(face)]);
      const int edges = shared_edges(room, scene.rooms[beyond], face / 2, corner_bits);
      row.portals[face][i] = {static_cast<std::uint16_t>(beyond), static_cast<std::uint8_t>(back),
                              static_cast<std::uint8_t>(edges)};
    }
  return row;
}

turn_row compile_turn(const Turn& turn, int frame) {
  return {turn.since == frame, turn.start, turn.step, turn.every, turn.per_line};
}

int compile_colours(const Palette& palette) {
  int colours = 0;
  for (int i = 0; i < 4; ++i) colours |= palette[i] << (ColourBits * i);
  return colours;
}

vec3 negated(const Vector& v) { return {-v[0], -v[1], -v[2]}; }

shot_row compile_shot(const Shot& shot) {
  const Camera& camera = shot.camera;
  shot_row row;
  row.frame = shot.frame;
  row.restart = shot.restart;
  row.start_room = camera.room;
  row.start = negated(camera.position);
  row.velocity = negated(camera.velocity);
  row.yaw = compile_turn(camera.yaw, shot.frame);
  row.pitch = compile_turn(camera.pitch, shot.frame);
  row.fov = compile_turn(camera.fov, shot.frame);
  row.interlace = camera.interlace;
  row.shading_b = shot.look.shading == Shading::Dithered;
  row.inverse = shot.look.inverse;
  row.pattern = shot.look.pattern == Pattern::Off       ? PatternOff
                : shot.look.pattern == Pattern::Partial ? PatternPartial
                                                        : PatternFull;
  row.colours = compile_colours(shot.look.palette);
  row.pattern_colours = compile_colours(shot.look.pattern_palette);
  return row;
}

}  // namespace

scene_program compile_scene(const SceneFile& scene) {
  scene_program program;
  const SceneWidths widths = scene_widths(scene);
  program.corner_bits = built_corner_bits(scene, widths);
  const int rooms = static_cast<int>(scene.rooms.size());
  for (int number = 0; number < rooms; ++number)
    program.rooms.push_back(compile_room(scene, number, program.corner_bits));
  for (const Shot& shot : scene.shots) program.shots.push_back(compile_shot(shot));
  program.frames = scene.frames;
  program.navigator_bits = std::min(widths.camera_bits, NavigatorPortBits);
  program.portals_per_face = std::max(1, widths.portals_per_face);
  return program;
}

}  // namespace racebeam
