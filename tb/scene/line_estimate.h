// Estimates how hard a scene is for the chip, without the chip: rays through the boxes in double
// precision, counted as the interval tracer would work them off.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/scene/camera_path.h"

namespace racebeam {

struct LineEstimate {
  static constexpr int Budget = 1530;  ///< clocks from the tracer's start to the end of the line

  int clocks = 0;     ///< of the worst line
  int intervals = 0;  ///< wall pieces in that line
  int frame = 0, y = 0;
};

/// The worst of some lines of some frames. `path` is fly(scene). A room counts 13 clocks, a split
/// some 10 more; restarts after a full interval stack are not counted.
LineEstimate estimate_worst_line(const SceneFile& scene, const CameraPath& path);

}  // namespace racebeam
