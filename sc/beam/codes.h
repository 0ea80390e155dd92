// Codes on the wires between units, the same in rtl/base/racebeam_pkg.sv.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

/// Where subdivider is: what decision_datapath tests, and whether it moves.
enum subdivider_state { StateLeft = 0, StateRight = 1, StateBisect = 2, StateReturn = 3 };

/// A colour on its way through the FIFO: an index, and checkered, HalfTone where every other pixel
/// has the next index.
constexpr int IndexMask = 3, HalfTone = 4;

/// What is asked of the world's table.
enum look_way {
  LookThrough = 0,   // the room behind portal look_portal of the face
  LookNext = 1,      // that room's face towards us: the room behind its portal after ours
  LookPrevious = 2,  // ... before ours
};

/// What decision_datapath does to its corner on the nav_line (S half size, R position of the room).
enum corner_op {
  CornerHold = 0,
  CornerAddVelocity = 1,
  CornerAddS = 2,
  CornerSubtract2S = 3,
  CornerLeavePlus = 4,   // - R - S
  CornerLeaveMinus = 5,  // - R + S
  CornerAddR = 6,
  CornerCamera = 7,  // := the camera; the room := its room
};

}  // namespace racebeam
