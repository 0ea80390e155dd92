// trace_2: the golden tracer that asks every pixel's ray by itself, room by room.
//
// On the chip's integer rays with exact products. It follows the article's pseudocode of that name
// and is written in terms of which of two planes a ray reaches first; it shares no decision code
// with trace_4 or with the chip. It differs from trace_4 only where an edge chatters: with rays
// that are rounded to integers a decision may switch more than once along a line, and an interval
// tracer then knows one switch of several.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tb/golden/golden_work.h"

namespace racebeam {

/// What the ray `dr` hits in a world whose rooms are moved by `offset_z`.
GoldenHit trace_2(const GoldenWorld& world, const vec3& dr, int offset_z);

/// The rooms on the way of the ray, indices in GoldenWorld::rooms: from the camera's to the one in
/// whose wall it ends; and that wall.
struct GoldenWay {
  GoldenHit hit;
  std::vector<int> rooms;
};
GoldenWay trace_2_way(const GoldenWorld& world, const vec3& dr, int offset_z);

/// All pixels of line `y`; adds to `work` if there is one.
GoldenHits trace_2_line(const GoldenWorld& world, const GoldenRays& rays, int y,
                        RayWork* work = nullptr);

}  // namespace racebeam
