// trace_state: the place of a ray in the decision tree, one question at a time: what trace_3 and
// trace_4 walk on.
//
// The article's decision(), wall_hit() and next_trace_state(), with the first question about the
// signs of the ray that its text adds (contract 11.2). Exact products.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "tb/golden/golden_picture.h"

namespace racebeam {

/// A node of the decision tree.
struct TraceState {
  /// In the order in which a room asks them. The first is asked once. The next four are asked anew
  /// for each opening of a face until one is not missed.
  enum Question { Signs, FarFirst, FarSecond, NearFirst, NearSecond, XOrY, Exit };

  int room = 0, depth = 0;  ///< the room may be one behind an opening that is under test
  int left = 0;             ///< the room that is left
  int opening = 0;          ///< of the face by which it is left
  Question question = Signs;
  int signs = 0;          ///< of the ray, bit a for axis a
  int face = 0;           ///< axis of the opening by which the room is entered
  bool y_wins = false;    ///< answer to XOrY
  bool wall_hit = false;  ///< nothing to ask any more: a wall across `face` is hit

  bool negative() const { return (signs >> face & 1) != 0; }
  /// A room has been entered, and nothing is asked in it yet.
  bool enters() const { return question == XOrY && depth > 0; }
  // Of a wall_hit:
  GoldenEnd end() const { return {{face, negative()}, left, depth - 1}; }
  /// The face has no opening, or the room is the deepest that may be entered.
  bool is_solid() const { return opening == 0; }
};

/// The question of a state, for any ray: its three signs, or on which side of an edge it passes.
struct TraceQuestion {
  bool signs;
  int a, b;                ///< axes across the edge
  int corner_a, corner_b;  ///< the edge's place on them
  bool inverted;

  /// `dr` may have any scale.
  int answer(const vec3& dr) const {
    if (signs) return (dr[0] < 0) | (dr[1] < 0) << 1 | (dr[2] < 0) << 2;
    bool greater_equal = corner_b < 0;
    if (!greater_equal && corner_a >= 0)
      greater_equal = corner_a * magnitude(dr[b]) >= corner_b * magnitude(dr[a]);
    return greater_equal != inverted;
  }

 private:
  /// One's complement (contract 11.3).
  static std::int64_t magnitude(int component) { return component < 0 ? ~component : component; }
};

/// The decision tree of a line.
class TraceTree {
 public:
  /// In a world whose rooms are moved by `offset_z`.
  TraceTree(const GoldenWorld& world, int offset_z) : world_(world), offset_z_(offset_z) {}

  TraceQuestion question(const TraceState& state) const;
  /// Where an answer leads from a state that is no wall_hit.
  TraceState next(TraceState state, int answer) const;

 private:
  int corner(const TraceState& state, int axis) const;
  void try_opening(TraceState& state, int opening) const;

  const GoldenWorld& world_;
  const int offset_z_;
};

}  // namespace racebeam
