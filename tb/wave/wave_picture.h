// A waveform as a drawing for documents: SVG with a ruler of clocks and a lane for each signal.
//
// The clock is a square wave, bits are levels, numbers and words are hexagons with the value inside
// where it fits, once for as long as it stays; otherwise it is in the shape's <title>. Before its
// first change a lane is hatched. Lanes are grouped by unit. Nothing is loaded and nothing runs:
// the file is fit for a page of its own, an <img> and GitHub, and white in dark mode too.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/wave/clocked_waves.h"

namespace racebeam {

/// The text of the SVG. Every lane is a <g class="lane" data-signal="PATH">.
std::string wave_picture(const ClockedWaves& waves);

}  // namespace racebeam
