// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/frame_maps.h"

#include <algorithm>

namespace racebeam {

namespace {

// The clock of a line in which a monitor samples each column.
std::vector<int> sample_clocks(const Raster& raster) {
  std::vector<int> clocks;
  for (int clock = raster.active_begin; clock < raster.line_clocks(); ++clock)
    if (raster.clocks[clock].last) clocks.push_back(clock);
  return clocks;
}

}  // namespace

const char* map_name(MapKind kind) {
  return kind == MapKind::Slack ? "slack" : kind == MapKind::Cost ? "cost" : "depth";
}

float FrameMap::at(int column, int row) const {
  return values[static_cast<std::size_t>(row) * VisibleColumns + column];
}

FrameMap make_map(MapKind kind, const std::vector<IntervalEvent>& events, const Raster& raster) {
  const std::vector<int> sampled = sample_clocks(raster);
  FrameMap map{kind, std::vector<float>(VisibleColumns * VisibleRows, FrameMap::Unknown)};
  for (int row = 0; row < VisibleRows; ++row)
    map.values[static_cast<std::size_t>(row) * VisibleColumns] =
        kind == MapKind::Slack ? static_cast<float>(sampled.front()) : 0;
  for (const IntervalEvent& event : events) {
    const int row = event.y - FirstVisibleLine;
    float* line = &map.values[static_cast<std::size_t>(row) * VisibleColumns];
    const float cost = static_cast<float>(event.decisions) / std::max(event.length(), 1);
    for (int column = event.from + 1; column <= std::min(event.to + 1, LastPixel); ++column) {
      if (kind == MapKind::Cost) line[column] = cost;
      else if (event.known())
        line[column] = static_cast<float>(kind == MapKind::Depth ? event.depth
                                                                 : sampled[column] - event.clock);
    }
  }
  return map;
}

}  // namespace racebeam
