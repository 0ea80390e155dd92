// geometry: the golden tracer that knows nothing of the chip's arithmetic.
//
// Exact boxes and the ideal camera in double precision: where a ray leaves a box, and whether that
// point lies in the opening. It keeps two of the chip's promises, the number of rooms a ray may
// enter and one line's position against the next, and none of its shortcuts.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/golden/golden_picture.h"

namespace racebeam {

/// Where a ray ends in a world whose rooms are moved by `offset_z`.
GoldenEnd geometry_end(const GoldenWorld& world, const GoldenVector& ray, int offset_z);

/// What it hits.
GoldenHit geometry(const GoldenWorld& world, const GoldenVector& ray, int offset_z);

/// All pixels of line `y`.
GoldenHits geometry_line(const GoldenWorld& world, const GoldenIdeal& camera, int y);

}  // namespace racebeam
