// What a store says of figures of a point, as far as it is measured.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tb/sweep/figures.h"
#include "tb/sweep/frame_table.h"
#include "tb/sweep/front.h"

namespace racebeam {

struct PointReading {
  bool there = false;
  Reading reading{};
};

/// A point's frames of one scene, and the order in which it takes them.
struct SceneFrames {
  FrameKey key;
  const std::vector<int>* order;
};

Reading::Kind reading_kind(const PointFigure& figure);

/// From the first frames of each scene, and guard frames; columns are read once. Those of designs
/// are not there: no frame has them.
std::vector<PointReading> read_figures(const FrameTable& table,
                                       const std::vector<SceneFrames>& scenes,
                                       const std::vector<const PointFigure*>& figures, int frames);

}  // namespace racebeam
