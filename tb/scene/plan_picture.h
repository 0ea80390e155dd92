// Draws a scene: from above (north up) and, below that, from the south, with its portals and the
// camera's way. Only the rooms of the set in which the camera starts.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/scene/canvas.h"
#include "tb/scene/scene_file.h"

namespace racebeam {

/// What the colours mean.
struct PlanColours {
  static constexpr Colour Paper = 0;          ///< solid
  static constexpr Colour Wall = 42;          ///< outline of a room: grey
  static constexpr Colour Low = 1, High = 6;  ///< inside of the lowest and of higher rooms: blue
  static constexpr Colour Portal = 12;        ///< green
  static constexpr Colour Way = 48;           ///< the camera's: red
  static constexpr Colour Start = 60;         ///< yellow
};

/// Scaled to fit 1000 pixels in each view, at most 1 pixel for each unit of length.
Canvas draw_plan(const SceneFile& scene);

}  // namespace racebeam
