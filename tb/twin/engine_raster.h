// The raster that a chip of any engine is clocked by.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/engine.h"
#include "tb/monitor/raster.h"

namespace racebeam {

inline Raster raster_of(const engine& built, const knob_values& k) {
  const video_clocks video = built.video(k);
  return Raster(video.clocks_per_pixel, video.speed);
}

}  // namespace racebeam
