// trace_3: the golden tracer that is a machine for one ray: a question a clock, pixel by pixel.
//
// The article's step between trace_2, which is one function, and trace_4, which asks intervals: the
// chip as it would be without them. It shows what trace_2 shows, decision for decision, and counts
// its clocks by the chip's own: one for a question (the chip: one at each end of an interval), one
// more to change rooms, one to hand out the colour and step the ray to the next pixel. Not counted,
// as in the chip's busy clocks: the camera, and waiting for the beam.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/golden/golden_work.h"

namespace racebeam {

/// All pixels of line `y`; adds to `work` if there is one.
GoldenHits trace_3_line(const GoldenWorld& world, const GoldenRays& rays, int y,
                        RayWork* work = nullptr);

}  // namespace racebeam
