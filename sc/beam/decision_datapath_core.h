// Behaviour of decision_datapath (decision_datapath.h), inlined into whatever runs it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <tuple>

#include "sc/base/constants.h"
#include "sc/base/fixed_point.h"
#include "sc/base/probe.h"
#include "sc/beam/knobs.h"

namespace racebeam {

/// Sum of the partial products of x * m that weigh 2^cut or more, divided by 2^cut.
[[gnu::always_inline]] inline int truncated_product(int x, int m, int cut) {
  int sum = (x >> cut) * m;
  for (int i = 0; i < cut; ++i)
    if (x >> i & 1) sum += m >> (cut - i);
  return sum;
}

/// What the partial products below 2^cut add up to, by the low bits of both factors.
template <int Cut>
struct dropped_products {
  std::uint8_t sum[1 << Cut][1 << Cut]{};

  constexpr dropped_products() {
    for (int x = 0; x < 1 << Cut; ++x)
      for (int m = 0; m < 1 << Cut; ++m)
        for (int i = 0; i < Cut; ++i)
          if (x >> i & 1)
            sum[x][m] = static_cast<std::uint8_t>(sum[x][m] + ((m & low_bits(Cut - i)) << i));
  }
};
constexpr int ChipCut = 5;
inline constexpr dropped_products<ChipCut> chip_dropped_products{};

/// truncated_product by one multiplication where a table holds what is dropped.
[[gnu::always_inline]] inline int product(int x, int m, int cut) {
  if (cut != ChipCut) return truncated_product(x, m, cut);
  constexpr int low = low_bits(ChipCut);
  return (x * m - chip_dropped_products.sum[x & low][m & low]) >> ChipCut;
}

/// The levels (bits) of a portal whose edges the scene says need no decision: the scene does not
/// know of the mirrored world. A call, so that it costs nothing in the chip, which has no such
/// edges.
[[gnu::noinline]] inline int edges_seen(int edges, int face, int signs) {
  int levels = 0;
  for (int level = 0; level < 4; ++level) {
    const int a = (face + 2 - (level & 1)) % 3;
    levels |= (edges >> (level ^ (bit_of(signs, a) ? 2 : 0)) & 1) << level;
  }
  return levels;
}

/// Behaviour of decision_datapath.
struct decision_datapath_core {
  int depth_q = 0, level_q = 2;
  int room_q = 0;
  vec3 corner_q{};
  int face_q = 0, hit_face_q = 0;
  bool dom_q = false, dom_prev_q = false;
  bool wall_q = false, second_q = false, descend_q = false;
  // Several portals in a face only: the one the room was entered by, and the one that leads back.
  int portal_q = 0, back_q = 0;
  // skip_shared_edges=on only: extent of the room being left, and per depth the levels (bits) that
  // need no decision.
  vec3 left_far_q{}, left_near_q{};
  int shared_q[16]{};

  struct inputs {
    // Re-rooting
    bool tracer_reset, restart, nav_line, active_start;
    vec3 nav_position;  // signed
    int nav_room;
    // Navigator's controls, on the nav_line
    int nav_axis, nav_portal;
    bool nav_negative, nav_move;
    int nav_op;
    vec3 velocity;
    // subdivider
    bool descend, climb, in_return;
    int cur, signs;  // decision to descend with; stored ray signs
    int leave;       // {leaves by a face or past a portal's edge, decision}
    // stacks
    int top_tag, face_read;
    // scene: the current room, the room looked for, and its portal that leads back here
    vec3 half_size, position;
    int neighbour, back;
    int edges;       // of the face looked through: on or beyond those of the room behind
    bool interlace;  // this line shows the previous camera position
  };

  [[gnu::always_inline]] int tag() const {
    return portal_q << TagBits | depth_q << LevelBits | level_q;
  }
  /// Rooms entered on the way to room_q, which changes a clock before depth_q does.
  /// The room is one behind the opening that was asked about last, or would have been.
  bool is_behind() const { return level_q != 7 || second_q; }
  int rooms_entered() const { return depth_q + (second_q && descend_q && level_q == 7); }
  /// Bits of the decision that count: the three signs at the top of the tree, else the bit.
  [[gnu::always_inline]] int mask() const { return depth_q == 0 && level_q < 4 ? 14 : 1; }
  /// {sign z, sign y, sign x, bit} for a ray direction.
  int decide(const vec3& dr, const knobs& k) const;

  /// What scene is asked for.
  struct lookup {
    int axis, signs;  // of the face; per axis, 1 for towards negative coordinates
    int portal, way;  // look_way
  };
  /// A climb looks back through the face the room was entered by, so does a move to the portal
  /// before or after, and with skip_shared_edges=table every test of a portal's edge; else the
  /// lookup follows the ray.
  lookup look(const inputs& in, const knobs& k) const;
  /// A room is entered: the face stack is written at this depth.
  [[gnu::always_inline]] bool face_write(const inputs& in) const {
    return in.leave && level_q == 7 && in.neighbour != SolidRoom;
  }
  [[gnu::always_inline]] int face_code() const {
    return back_q << (FaceBits + PortalBits) | portal_q << FaceBits | face_q | dom_prev_q;
  }

  void clock(const inputs& in, const knobs& k);

  bool operator==(const decision_datapath_core& other) const {
    const auto all = [](const decision_datapath_core& c) {
      return std::tie(c.depth_q, c.level_q, c.room_q, c.corner_q, c.face_q, c.hit_face_q, c.dom_q,
                      c.dom_prev_q, c.wall_q, c.second_q, c.descend_q, c.portal_q, c.back_q);
    };
    return all(*this) == all(other) && left_far_q == other.left_far_q &&
           left_near_q == other.left_near_q &&
           std::equal(std::begin(shared_q), std::end(shared_q), std::begin(other.shared_q));
  }
  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit, const knobs& k) const {
    visit("depth_q", DepthBits, [this] { return depth_q; });
    visit("level_q", LevelBits, [this] { return level_q; });
    visit("room_q", k.free_flight || k.portals_per_face > 1 ? RoomPortBits : RoomBits,
          [this] { return room_q; });
    for (int a = 0; a < 3; ++a)
      visit(element("corner_q", a), k.corner_bits, [this, a] { return corner_q[a]; });
    visit("face_q", 2, [this] { return face_q; });
    visit("hit_face_q", 2, [this] { return hit_face_q; });
    visit("dom_q", 1, [this] { return dom_q; });
    visit("dom_prev_q", 1, [this] { return dom_prev_q; });
    visit("wall_q", 1, [this] { return wall_q; });
    visit("second_q", 1, [this] { return second_q; });
    visit("descend_q", 1, [this] { return descend_q; });
    visit("portal_q", PortalBits, [this] { return portal_q; });
    visit("back_q", PortalBits, [this] { return back_q; });
    if (k.skip_shared_edges != SharedEdgesOn) return;
    for (int a = 0; a < 3; ++a) {
      visit(element("g_shared_edges.left_far_q", a), k.corner_bits,
            [this, a] { return left_far_q[a]; });
      visit(element("g_shared_edges.left_near_q", a), k.corner_bits,
            [this, a] { return left_near_q[a]; });
    }
    for (int n = 0; n < 1 << DepthBits; ++n)
      visit(element("g_shared_edges.shared_q", n), 4, [this, n] { return shared_q[n]; });
  }

 private:
  [[gnu::always_inline]] int new_face(int decision) const {
    const bool bit = decision & 1;
    return dom_q ? (bit ? 2 : 1) : (bit ? 0 : 2);
  }
  [[gnu::always_inline]] bool go_down(const inputs& in) const {
    return in.descend || (second_q && descend_q);
  }
  [[gnu::always_inline]] static int target_depth(const inputs& in) {
    return in.top_tag >> LevelBits & low_bits(DepthBits);
  }
  [[gnu::always_inline]] static int target_portal(const inputs& in) {
    return in.top_tag >> TagBits;
  }
  /// Position of the room in the mirrored world.
  [[gnu::always_inline]] static int mirrored_position(int a, const inputs& in) {
    return bit_of(in.signs, a) ? -in.position[a] : in.position[a];
  }
  /// Which corner of the room a level tests: -1 towards the camera, 1 away from it.
  [[gnu::always_inline]] int corner_sign(int level, int a) const {
    if (level >= 4) return 1;
    return level < 2 && a != face_q ? 1 : -1;
  }
  /// The first level from `level` on that needs a decision.
  [[gnu::always_inline]] int next_test(int level, const inputs& in, const knobs& k) const {
    if (k.skip_shared_edges) {
      const int shared = k.skip_shared_edges == SharedEdgesOn
                             ? shared_q[depth_q]
                             : edges_seen(in.edges, face_q, in.signs);
      while (level < 4 && (shared >> level & 1)) ++level;
    }
    return level < 4 ? level : 6;
  }
  void descend(const inputs& in, const knobs& k);
  void enter(const inputs& in, const knobs& k);
  int shared_edges(const inputs& in, const knobs& k) const;
  void go_to_test(int level, const inputs& in);
  void arrive(const inputs& in);
  void leave(const inputs& in);
  void go_beside(int portal, const inputs& in);
  void climb(const inputs& in);
  void navigate(const inputs& in);
  [[gnu::always_inline]] void wrap_corner(const knobs& k) {
    for (int& c : corner_q) c = wrap_signed(c, k.corner_bits);
  }
  [[gnu::always_inline]] void hit_wall(int face) {
    if (!wall_q) hit_face_q = face;
    wall_q = true;
  }
};

}  // namespace racebeam

#include "sc/beam/decision_datapath_moves.h"
