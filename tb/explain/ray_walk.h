// RayWalk: the way of a single ray through the decision tree, question by question.
//
// The chip's own units go it: the tracer is given an interval of one pixel and a beam that waits.
// What an interval shares with its neighbours is asked here once, from the root of the tree on.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/beam/ray_stepper.h"
#include "tb/explain/line_story.h"
#include "tb/show/show.h"

namespace racebeam {

/// The rays of a visible line: as the camera leaves them, and moved by the chip's steps.
struct LineRays {
  vec3 dr_0, ddr;

  vec3 ray(int pixel, const knobs& k) const;
};

/// The rays of line `y`, -240..239, of a frame. Runs the chip from the start of the frame.
LineRays line_rays(const Show& show, const knobs& k, int frame, int y);

/// A question, its answer, and the numbers that it was answered by.
struct RayQuestion {
  TracerStep step;  ///< place, face and answer
  vec3 corner;      ///< under test: from the camera, in the world mirrored along the ray
  vec3 half_size;   ///< of the room
};

struct RayWalk {
  /// The ray of pixel 0..639 of line `y`, -240..239.
  RayWalk(const Show& show, const knobs& k, int frame, int y, int pixel);

  vec3 ray;
  std::vector<RayQuestion> questions;  ///< the first: the signs of the ray
  int wall;                            ///< axis of the face in which the ray ends

  bool negative(int axis) const { return ray[axis] < 0; }
  /// The ray in the mirrored world, as the multipliers have it: |dr|, or |dr| - 1 if negative.
  vec3 magnitudes() const;
  /// The room before the last portal that was asked about, or the only one: its first question,
  /// level 6, is questions[last_room()]; level 7 follows, and the portal's questions after that.
  std::size_t last_room() const;
};

}  // namespace racebeam
