// Draws a scene with cairo: each storey from above, north up, and each set from the south, with the
// names of the rooms, the ways from room to room and the camera's way with its frames.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/scene/scene_file.h"

namespace racebeam {

enum class PlanFormat { Png, Svg };

struct PlanDrawing {
  std::string bytes;  ///< of the whole file
  int width, height;  ///< pixels
};

/// The scene has no faults. The same scene gives the same bytes. Throws std::runtime_error if cairo
/// cannot draw.
PlanDrawing draw_plan(const SceneFile& scene, PlanFormat format);

}  // namespace racebeam
