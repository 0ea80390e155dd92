// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/trace_axis.h"

#include <limits>

namespace racebeam {

TraceAxis::TraceAxis(const Raster& raster, bool races_beam)
    : Raster(raster), of_pictures(!races_beam) {
  if (races_beam) return;
  const int most = std::numeric_limits<int>::max() / raster.line_clocks();
  lines = most - most % raster.lines;
}

}  // namespace racebeam
