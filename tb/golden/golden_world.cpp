// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/golden_world.h"

#include "sc/chip_core.h"
#include "sc/scene.h"
#include "sc/sequencer.h"

namespace racebeam {

namespace {

constexpr int RayOfPattern = 64;  // a y component whose bits 7:6 are not 0

/// A room that was found, and from how far.
struct Found {
  int id, depth;
  vec3 position;
};

int index_of(std::vector<Found>& found, const Found& room) {
  for (std::size_t i = 0; i < found.size(); ++i)
    if (found[i].id == room.id && found[i].position == room.position) return static_cast<int>(i);
  found.push_back(room);
  return static_cast<int>(found.size()) - 1;
}

}  // namespace

GoldenWorld::GoldenWorld(int frame, const knobs& k)
    : room_depth(k.room_depth_limit()),
      corner_bits(k.corner_bits),
      bisection(k.bisection),
      dithering(k.dithering != 0) {
  sequencer_core sequencer;
  sequencer.frame_q = frame;
  sequencer_core::inputs in{true, false, true, 0};
  const auto of_rooms = sequencer.comb(in, {});
  in.dr2_y = RayOfPattern;
  const auto of_pattern = sequencer.comb(in, {});
  interlace = k.interlace && of_rooms.scene_interlace;
  shading_b = of_rooms.shading_b;
  inverse = of_rooms.inverse;
  palette = of_rooms.palette;
  pattern_palette = of_pattern.palette;
  lock = of_rooms.lock     ? GoldenLock::Full
         : of_pattern.lock ? GoldenLock::Partial
                           : GoldenLock::None;
  const auto camera = fly_to(frame, k);
  explore(of_rooms.scene_flags, camera.room_q, camera.position_q);
}

void GoldenWorld::explore(int flags, int id, const vec3& position) {
  std::vector<Found> found = {{id, 0, position}};
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Found here = found[i];
    const auto room = scene_core::geometry(flags, here.id);
    GoldenRoom made{room.half_size, here.position, {}};
    made.neighbour.fill(-1);
    for (int axis = 0; axis < 3 && here.depth < room_depth; ++axis)
      for (const bool negative : {false, true}) {
        const int next = scene_core::neighbour(flags, here.id, axis, negative);
        if (next == SolidRoom) continue;
        const auto beyond = scene_core::geometry(flags, next);
        Found there{next, here.depth + 1, here.position};
        for (int a = 0; a < 3; ++a)
          there.position[a] += wrap_signed(beyond.position[a] - room.position[a], CornerBits);
        made.neighbour[golden_face(axis, negative)] = index_of(found, there);
      }
    rooms.push_back(made);
  }
}

}  // namespace racebeam
