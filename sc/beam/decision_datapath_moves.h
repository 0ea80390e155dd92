// The functions of decision_datapath_core.h, which includes this: the decision, and one clock of
// moves through the tree.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <utility>

#include "sc/beam/codes.h"
#include "sc/beam/decision_datapath_core.h"

namespace racebeam {

// Functions of knobs that the chip has not are calls: inlined, they cost decisions of the chip a
// third of their speed, since the compiler looks at them before it knows the knobs.

/// A corner, shifted, to the nearest number of `bits` bits.
[[gnu::noinline]] inline int rounded_factor(int corner, int shift, int bits) {
  const int half = shift > 0 ? corner >> (shift - 1) & 1 : 0;
  return std::min((corner >> shift) + half, low_bits(bits));
}

[[gnu::always_inline]] inline int decision_datapath_core::decide(const vec3& dr,
                                                                 const knobs& k) const {
  const int signs = (dr[0] < 0) | (dr[1] < 0) << 1 | (dr[2] < 0) << 2;
  int axis;
  bool inverted;
  if (level_q >= 4) {
    axis = level_q & 1 ? (dom_q ? 0 : 1) : 2;
    inverted = axis == 1;
  } else {
    axis = face_q + 1 + (level_q & 1);
    if (axis > 2) axis -= 3;
    inverted = (level_q == 0 || level_q == 3) != (axis == 1);
  }
  // The other two axes: y z, x z, x y.
  const int ca = axis == 0 ? corner_q[1] : corner_q[0], cb = axis == 2 ? corner_q[1] : corner_q[2];
  const int dr_a = axis == 0 ? dr[1] : dr[0], dr_b = axis == 2 ? dr[1] : dr[2];
  bool ge;
  if (cb < 0) {
    ge = true;
  } else if (ca < 0) {
    ge = false;
  } else {
    const int high = (ca | cb) >> k.corner_factor_bits;
    const int shift = high ? 32 - __builtin_clz(high) : 0;
    const int ma = dr_a < 0 ? ~dr_a : dr_a, mb = dr_b < 0 ? ~dr_b : dr_b;
    int factor_a = ca >> shift, factor_b = cb >> shift;
    if (k.corner_rounding) {
      factor_a = rounded_factor(ca, shift, k.corner_factor_bits);
      factor_b = rounded_factor(cb, shift, k.corner_factor_bits);
    }
    ge = product(factor_a, mb, k.partial_products_cut) >=
         product(factor_b, ma, k.partial_products_cut);
  }
  return signs << 1 | (ge != inverted);
}

[[gnu::always_inline]] inline decision_datapath_core::lookup decision_datapath_core::look(
    const inputs& in, const knobs& k) const {
  if (in.nav_line) return {in.nav_axis, in.nav_negative ? 7 : 0, in.nav_portal, LookThrough};
  if (in.climb) {
    const bool beside = target_depth(in) == depth_q && target_portal(in) != portal_q;
    return {face_q, ~in.signs & 7, back_q, beside ? LookPrevious : LookThrough};
  }
  if (in.leave && level_q < 4 && k.portals_per_face > 1)
    return {face_q, ~in.signs & 7, back_q, LookNext};
  if (k.skip_shared_edges == SharedEdgesTable && (level_q < 4 || second_q))
    return {face_q, ~in.signs & 7, back_q, LookThrough};
  return {new_face(in.leave), in.signs, 0, LookThrough};
}

[[gnu::always_inline]] inline void decision_datapath_core::clock(const inputs& in, const knobs& k) {
  const bool down = go_down(in);
  if (in.tracer_reset || (in.restart && !in.nav_line) || (in.nav_line && in.active_start)) {
    depth_q = 0;
    level_q = 2;
    room_q = in.nav_room;
    corner_q = in.nav_position;
    second_q = wall_q = false;
    portal_q = back_q = 0;
    wrap_corner(k);
  } else {
    const vec3 corner = corner_q;
    const int room = room_q;
    if (in.in_return && !down) wall_q = false;
    if (down) {
      descend(in, k);
      wrap_corner(k);
    } else if (in.climb) {
      climb(in);
      wrap_corner(k);
    } else {
      second_q = false;
    }
    if (in.nav_line) {
      corner_q = corner;
      room_q = room;
      navigate(in);
      wrap_corner(k);
    }
  }
  descend_q = in.descend;
}

// One step towards the leaves (contract 11.5). Corner terms are those of the mirrored world:
// s * R is R where the ray is positive, -R where it is negative.
[[gnu::always_inline]] inline void decision_datapath_core::descend(const inputs& in,
                                                                   const knobs& k) {
  const bool bit = in.cur & 1;
  const bool was_second = std::exchange(second_q, false);
  if (level_q == 6) {
    dom_prev_q = dom_q;
    dom_q = bit;
    level_q = 7;
  } else if (level_q == 7 && !was_second) {
    const int face = new_face(in.cur);
    if (depth_q == k.room_depth_limit() || in.neighbour == SolidRoom) hit_wall(face);
    if (in.neighbour == SolidRoom) return;
    for (int a = 0; a < 3; ++a) {
      const int r = mirrored_position(a, in);
      if (k.skip_shared_edges == SharedEdgesOn) {
        left_far_q[a] = r + in.half_size[a];
        left_near_q[a] = r - in.half_size[a];
      }
      corner_q[a] -= r + in.half_size[a];
    }
    second_q = true;
    face_q = face;
    room_q = in.neighbour;
    portal_q = 0;
    back_q = in.back;
  } else if (level_q == 7) {
    if (depth_q == k.room_depth_limit()) hit_wall(face_q);
    enter(in, k);
  } else if (depth_q == 0 && level_q == 2) {
    for (int a = 0; a < 3; ++a) {
      const bool mirrored = bit_of(in.cur >> 1, a);
      corner_q[a] = (mirrored ? -corner_q[a] : corner_q[a]) + in.half_size[a];
      if (a == 2 && in.interlace) corner_q[a] += mirrored ? -1 : 1;
    }
    level_q = 6;
  } else if (depth_q == 0 || level_q >= 4) {
    ++level_q;              // off the tree, nav_line only
  } else if (was_second) {  // arrive behind the next portal
    if (k.skip_shared_edges == SharedEdgesOn) shared_q[depth_q] = 0;
    arrive(in);
  } else if (bit && k.portals_per_face > 1 && in.neighbour != SolidRoom) {
    leave(in);
    go_beside(portal_q + 1, in);
  } else {
    if (bit) hit_wall(face_q);
    else wall_q = false;
    go_to_test(next_test(level_q + 1, in, k), in);
  }
}

// The second half of entering a room: from the camera's side of its centre to its first test.
[[gnu::always_inline]] inline void decision_datapath_core::enter(const inputs& in, const knobs& k) {
  depth_q = (depth_q + 1) & low_bits(DepthBits);
  if (k.skip_shared_edges == SharedEdgesOn) shared_q[depth_q] = shared_edges(in, k);
  level_q = next_test(0, in, k);
  arrive(in);
}

// From the camera to the corner that the level tests, and back.
[[gnu::always_inline]] inline void decision_datapath_core::arrive(const inputs& in) {
  for (int a = 0; a < 3; ++a)
    corner_q[a] += mirrored_position(a, in) + corner_sign(level_q, a) * in.half_size[a];
}

[[gnu::always_inline]] inline void decision_datapath_core::leave(const inputs& in) {
  for (int a = 0; a < 3; ++a)
    corner_q[a] -= mirrored_position(a, in) + corner_sign(level_q, a) * in.half_size[a];
}

// Half way to the room behind another portal of the same face.
[[gnu::always_inline]] inline void decision_datapath_core::go_beside(int portal, const inputs& in) {
  portal_q = portal & low_bits(PortalBits);
  back_q = in.back;
  room_q = in.neighbour;
  level_q = 0;
  second_q = true;
}

// Levels 0..3 (bits) whose edge of the room being entered does not narrow the face left.
[[gnu::always_inline]] inline int decision_datapath_core::shared_edges(const inputs& in,
                                                                       const knobs& k) const {
  int shared = 0;
  for (int level = 0; level < 4; ++level) {
    const int a = (face_q + 2 - (level & 1)) % 3;  // dimension that the edge bounds
    const int r = mirrored_position(a, in), s = in.half_size[a];
    const int beyond = level < 2 ? r + s - left_far_q[a] : left_near_q[a] - (r - s);
    if (wrap_signed(beyond, k.corner_bits) >= 0) shared |= 1 << level;
  }
  return shared;
}

// Moves within a room: only the corner's signs change.
[[gnu::always_inline]] inline void decision_datapath_core::go_to_test(int level, const inputs& in) {
  for (int a = 0; a < 3; ++a)
    corner_q[a] += (corner_sign(level, a) - corner_sign(level_q, a)) * in.half_size[a];
  level_q = level;
}

// One step towards the root, to where top_tag points (contract 11.6).
[[gnu::always_inline]] inline void decision_datapath_core::climb(const inputs& in) {
  const int target_level = in.top_tag & low_bits(LevelBits);
  const bool was_second = std::exchange(second_q, false);
  if (target_depth(in) != depth_q) {  // leave the room
    if (!was_second) leave(in);
    if (level_q == 7) dom_q = dom_prev_q;
    depth_q = (depth_q - 1) & low_bits(DepthBits);
    room_q = in.neighbour;
    level_q = 7;
    second_q = true;
    const int face = in.face_read & low_bits(FaceBits);
    face_q = face == 3 ? 2 : face;
    dom_prev_q = face & 1;
    portal_q = in.face_read >> FaceBits & low_bits(PortalBits);
    back_q = in.face_read >> (FaceBits + PortalBits);
  } else if (target_portal(in) != portal_q) {  // leave it for the one behind the portal before
    if (!was_second) leave(in);
    if (level_q == 7) dom_q = dom_prev_q;
    go_beside(portal_q - 1, in);
  } else if (was_second) {  // arrive in the room
    if (level_q == 7 && target_level != 7) dom_q = dom_prev_q;
    level_q = target_level;
    if (depth_q == 0 && target_level < 4) {
      for (int a = 0; a < 3; ++a)
        corner_q[a] = (bit_of(in.signs, a) ? -corner_q[a] : corner_q[a]) + in.position[a];
    } else {
      arrive(in);
    }
  } else {  // within the room
    if (level_q == 7) dom_q = dom_prev_q;
    const int even = level_q & ~1;
    const int from = target_level == even ? level_q : even;
    if (from == 6 && depth_q == 0) {
      for (int a = 0; a < 3; ++a) {
        const bool mirrored = bit_of(in.signs, a);
        const int c = corner_q[a] - in.half_size[a];
        corner_q[a] = mirrored ? -c : c;
        if (a == 2 && in.interlace) corner_q[a] += mirrored ? 1 : -1;
      }
      level_q = 2;
      return;
    }
    int to = (from - 1) & low_bits(LevelBits);
    if (from == 6) to = target_level == 2 || target_level == 3 ? 3 : 1;
    if (target_level % 2 == 0) to &= ~1;
    if (depth_q != 0 && (from == 2 || from == 6)) go_to_test(to, in);
    level_q = to;
  }
}

// The nav_line: the navigator owns the corner and the room.
[[gnu::always_inline]] inline void decision_datapath_core::navigate(const inputs& in) {
  for (int a = 0; a < 3; ++a) {
    const int r = in.position[a], s = in.half_size[a];
    switch (in.nav_op) {
      case CornerAddVelocity: corner_q[a] += in.velocity[a]; break;
      case CornerAddS: corner_q[a] += s; break;
      case CornerSubtract2S: corner_q[a] -= 2 * s; break;
      case CornerLeavePlus: corner_q[a] -= r + s; break;
      case CornerLeaveMinus: corner_q[a] += s - r; break;
      case CornerAddR: corner_q[a] += r; break;
      case CornerCamera: corner_q[a] = in.nav_position[a]; break;
      default: break;
    }
  }
  if (in.nav_op == CornerCamera) room_q = in.nav_room;
  if (in.nav_move) room_q = in.neighbour;
}

}  // namespace racebeam
