// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/scene.h"

#include "sc/beam/sequencer.h"

namespace racebeam {

namespace {

constexpr int RoomPitch = 256;
constexpr int LastCell = 8;

/// A room id taken apart, and what kind of room it is.
struct cell {
  int i, j, k;
  bool odd_odd;    // blocked cell: a pillar, or a portal between corridors
  bool main_type;  // false: the shaft of a ceiling window
  cell(int flags, int id)
      : i(id & 15),
        j(id >> 4 & 15),
        k(id >> 8 & 1),
        odd_odd((flags & SceneBlocked) && (i & 1) && (j & 1)),
        main_type(k == 0 || odd_odd) {}
};

int room_id(int i, int j, int k) { return (k & 1) << 8 | (j & 15) << 4 | (i & 15); }

int neighbour_x(int flags, const cell& c, int d) {
  if (!c.main_type || (d < 0 && c.i == 0) || (d > 0 && c.i == LastCell)) return SolidRoom;
  if (flags & SceneBlocked) {
    const bool open = flags & ScenePortals ? !(c.odd_odd && c.k == 1) : c.j % 2 == 0;
    if (!open) return SolidRoom;
  }
  return room_id(c.i + d, c.j, c.k);
}

int neighbour_z(int flags, const cell& c, int d) {
  if (!c.main_type) return SolidRoom;
  if (!(flags & SceneTunnel) && ((d < 0 && c.j == 0) || (d > 0 && c.j == LastCell)))
    return SolidRoom;
  if (flags & SceneBlocked) {
    const bool open = flags & ScenePortals ? !(c.odd_odd && c.k == 0) : c.i % 2 == 0;
    if (!open) return SolidRoom;
  }
  const bool toggle = (flags & SceneBlocked) && (flags & ScenePortals) && (c.i & 1);
  return room_id(c.i, c.j + d, c.k ^ toggle);
}

// Edges of a face (scene.h): towards positive and negative coordinates of the axis two after the
// face's, and of the axis after.
constexpr int TwoAfterPositive = 1, AfterPositive = 2, TwoAfterNegative = 4, AfterNegative = 8;
int edges(bool two_after, bool after) {
  return two_after * (TwoAfterPositive | TwoAfterNegative) |
         after * (AfterPositive | AfterNegative);
}

}  // namespace

scene_core::room scene_core::geometry(int flags, int id) {
  const cell c(flags, id);
  room r;
  r.position = {RoomPitch * c.i, 0, RoomPitch * c.j};
  if (c.main_type) {
    const int main_size = flags & SceneNarrow ? 80 : 128;
    const int side_size = flags & SceneNarrow ? 176 : 128;
    r.half_size = {c.i & 1 ? side_size : main_size, 256, c.j & 1 ? side_size : main_size};
    if (flags & SceneHeights) r.half_size[1] = 256 * (1 + !(c.i & 1) + !(c.j & 1));
    if ((flags & ScenePortals) && c.odd_odd) {
      r.half_size[c.k ? 0 : 2] = 80;
      r.half_size[1] = 160;
    }
    if (flags & SceneTunnel) {
      static constexpr int bend_x[8] = {0, -2, -3, -2, 0, 2, 3, 2};
      static constexpr int bend_y[8] = {3, 2, 0, -2, -3, -2, 0, 2};
      r.half_size[0] = 256;
      r.position[0] = 64 * bend_x[c.j & 7];
      r.position[1] = 64 * bend_y[c.j & 7];
    }
  } else {
    r.position[1] = -272;
    r.half_size = {96, 16, 96};
  }
  for (int& p : r.position) p = wrap_signed(p, CornerBits);
  return r;
}

int scene_core::neighbour(int flags, int id, int axis, bool negative) {
  if ((id & low_bits(RoomBits)) == low_bits(RoomBits)) return 4;  // recovery, not in the demo
  const cell c(flags, id);
  const int d = negative ? -1 : 1;
  switch (axis) {
    case 0: return neighbour_x(flags, c, d);
    case 1:
      if (!(flags & SceneWindows) || c.odd_odd || c.k != (d > 0)) return SolidRoom;
      return room_id(c.i, c.j, d < 0);
    case 2: return neighbour_z(flags, c, d);
    default: return SolidRoom;
  }
}

// Rooms side by side have the same section, but for heights, what portals and windows narrow, and
// the bends of the tunnel.
int scene_core::shared_edges(int flags, int id, int axis, bool negative) {
  const cell c(flags, id);
  const bool portal = (flags & ScenePortals) && c.odd_odd;
  const bool odd_i = c.i & 1, odd_j = c.j & 1;
  if (axis == 1) {
    const bool narrow = flags & SceneNarrow;
    return edges(c.main_type != (narrow && !odd_i), c.main_type != (narrow && !odd_j));
  }
  if (portal) return 0;
  const bool high = !(flags & SceneHeights) || !(axis == 0 ? odd_i : odd_j);
  if (axis == 0) return edges(true, high);
  if (!(flags & SceneTunnel)) return edges(high, true);
  const int bend = c.j - negative;  // between this place and the next one
  const bool left = bit_of(bend, 2) == bit_of(bend, 1), up = !bit_of(bend, 2);
  const int x = left != negative ? AfterPositive : AfterNegative;
  const int y = up != negative ? TwoAfterPositive : TwoAfterNegative;
  return flags & SceneHeights ? edges(high, false) | x : x | y;
}

scene::scene(const sc_core::sc_module_name& name, const knobs& k)
    : scene_pins(name), has_edges_(k.skip_shared_edges == SharedEdgesTable) {
  SC_HAS_PROCESS(scene);
  SC_METHOD(comb);
  sensitive << scene_flags_i << room_i << look_axis_i << look_signs_i;
}

void scene::comb() {
  const int flags = scene_flags_i.value(), id = room_i.value(), axis = look_axis_i.value();
  const auto room = scene_core::geometry(flags, id);
  half_size_o.drive(room.half_size);
  position_o.drive(room.position);
  const bool negative = bit_of(look_signs_i.value(), axis);
  neighbour_o.drive(scene_core::neighbour(flags, id, axis, negative));
  if (has_edges_) edges_o.drive(scene_core::shared_edges(flags, id, axis, negative));
}

}  // namespace racebeam
