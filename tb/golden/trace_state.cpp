// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/trace_state.h"

namespace racebeam {

/// The corner coordinate that the state's question is about.
int TraceTree::corner(const TraceState& state, int axis) const {
  const GoldenRoom& room = world_.rooms[state.room];
  const int centre = room.position[axis] + (axis == 2 ? offset_z_ : 0);
  const bool in_far_question =
      state.question == TraceState::FarFirst || state.question == TraceState::FarSecond;
  const bool far = state.question >= TraceState::XOrY || (in_far_question && axis != state.face);
  return world_.corner((state.signs >> axis & 1 ? -centre : centre) +
                       (far ? room.half_size[axis] : -room.half_size[axis]));
}

TraceQuestion TraceTree::question(const TraceState& state) const {
  int axis = 0;
  bool inverted = false;
  switch (state.question) {
    case TraceState::Signs: return {true, 0, 0, 0, 0, false};
    case TraceState::FarFirst: axis = state.face + 1, inverted = true; break;
    case TraceState::FarSecond: axis = state.face + 2; break;
    case TraceState::NearFirst: axis = state.face + 1; break;
    case TraceState::NearSecond: axis = state.face + 2, inverted = true; break;
    case TraceState::XOrY: axis = 2; break;
    case TraceState::Exit: axis = state.y_wins ? 0 : 1; break;
  }
  axis %= 3;
  const int a = axis == 0, b = axis == 2 ? 1 : 2;  // the other two axes
  return {false, a, b, corner(state, a), corner(state, b), inverted != (axis == 1)};
}

TraceState TraceTree::next(TraceState state, int answer) const {
  switch (state.question) {
    case TraceState::Signs:
      state.signs = answer;
      state.question = TraceState::XOrY;
      break;
    case TraceState::XOrY:
      state.y_wins = answer != 0;
      state.question = TraceState::Exit;
      break;
    case TraceState::Exit:
      state.face = state.y_wins ? (answer ? 2 : 1) : (answer ? 0 : 2);
      state.left = state.room;
      state.opening = 0;
      if (state.depth == world_.room_depth) state.wall_hit = true;
      else try_opening(state, 0);
      ++state.depth;
      break;
    default:
      if (answer) try_opening(state, state.opening + 1);
      else state.question = static_cast<TraceState::Question>(state.question + 1);
  }
  return state;
}

/// The first question about an opening of the face, or the wall behind the last one.
void TraceTree::try_opening(TraceState& state, int opening) const {
  const auto& behind =
      world_.rooms[state.left].neighbours[golden_face(state.face, state.negative())];
  state.opening = opening;
  state.wall_hit = opening == static_cast<int>(behind.size());
  if (state.wall_hit) return;
  state.room = behind[opening];
  state.question = TraceState::FarFirst;
}

}  // namespace racebeam
