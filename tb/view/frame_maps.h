// FrameMaps: what each pixel of a frame cost, how early it was known, how deep it looks.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tb/bench/interval_event.h"
#include "tb/monitor/raster.h"

namespace racebeam {

enum class MapKind { Slack, Cost, Depth };
constexpr MapKind MapKinds[] = {MapKind::Slack, MapKind::Cost, MapKind::Depth};
/// "slack", "cost", "depth".
const char* map_name(MapKind kind);

/// One value for each of 640 x 480 pixels of the screen, row by row. Pixel p of a line is shown in
/// column p + 1; column 0 is the FIFO's own pixel, which is known from the first clock on, costs
/// nothing and is 0 deep.
struct FrameMap {
  /// Not known before the line ended, or not traced yet.
  static constexpr float Unknown = -1e9F;

  MapKind kind;
  std::vector<float> values;

  float at(int column, int row) const;
};

/// Slack: clocks from the one in which the FIFO took a pixel to the one in which a monitor samples
/// it; 0 or less, or Unknown: the beam won, the pixel starved. Cost: decisions of the interval,
/// shared by its pixels. Depth: rooms entered. `raster` is that of the chip's clocks.
FrameMap make_map(MapKind kind, const std::vector<IntervalEvent>& events, const Raster& raster);

}  // namespace racebeam
