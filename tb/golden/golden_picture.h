// Pictures by the golden tracers, as the chip would show them.
//
// A golden tracer says for each pixel which wall its ray hits; the rest is done here once for all
// of them: shading, palette, inversion, and the chip's way of showing a line: pixel i in column i +
// 1, column 0 with index 0, pixel 639 never (contract 14). Frames with the ray pattern
// (contract 17.4): full lock shows in column p the pattern of pixel p; partial lock shows it in the
// columns whose ray says so, and in the others the rooms as if the line had been traced
// undisturbed. (The pattern moves the chip's dr2 under its tracer. Only with clocks to spare is the
// line traced before that begins, and then the pictures are equal.)
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sc/base/constants.h"
#include "tb/golden/golden_camera.h"
#include "tb/golden/golden_world.h"

namespace racebeam {

/// The wall that a ray hits.
struct GoldenHit {
  int face;       ///< axis across which the wall stands
  bool negative;  ///< hit by a ray towards negative coordinates
};

/// Hits of all pixels of a line.
using GoldenHits = std::array<GoldenHit, VisibleColumns>;

/// Where a ray ends: the wall, and the room that it stands in.
struct GoldenEnd {
  GoldenHit hit;
  int room;   ///< index in GoldenWorld::rooms
  int depth;  ///< rooms entered on the way to it
};

/// 640 x 480 colours, row by row, r * 16 + g * 4 + b.
using GoldenPicture = std::vector<std::uint8_t>;

/// The last one shows what the first one shows, and counts otherwise.
enum class GoldenTracer { Trace2, Trace4, Geometry, Trace3 };

/// By GoldenTracer: "trace2", "trace4", "geometry", "trace3".
const std::vector<std::string>& golden_tracer_names();

struct GoldenWork;

/// What a tracer makes of a world seen from a frame's camera; adds to `work` if there is one.
GoldenPicture golden_picture(GoldenTracer tracer, const GoldenWorld& world,
                             const GoldenCamera& camera, GoldenWork* work = nullptr);

/// Pixels in which two pictures differ.
int golden_difference(const GoldenPicture& a, const GoldenPicture& b);

}  // namespace racebeam
