// The time of a trace: frame after frame of the raster.
//
// An engine that does not race the beam has pictures instead, which take as many clocks as they
// take: a frame of the axis is a picture, and its lines go on over the frames of the raster.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/monitor/raster.h"

namespace racebeam {

struct TraceAxis : Raster {
  explicit TraceAxis(const Raster& raster = Raster(), bool races_beam = true);

  bool of_pictures;

  /// The line of the raster that a line of this is.
  int line_of_beam(int line) const {
    return of_pictures ? FirstLine + (line - FirstLine) % FrameLines : line;
  }
};

}  // namespace racebeam
