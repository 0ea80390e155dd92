// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/show/demo_parts.h"

#include <algorithm>
#include <stdexcept>

namespace racebeam {

// "twist": an angle changes from line to line. "ray pattern": shown instead of the rooms, in a part
// of the picture, which depends on the ray; "full ray pattern": everywhere (contract 17.4).
const std::vector<DemoPart>& demo_parts() {
  static const std::vector<DemoPart> parts = {
      {0, 2047, 0, 0, "pillars", ""},
      {2048, 2175, 0, 4, "pillars", "fov sweep"},
      {2176, 2303, 0, 5, "pillars", "fov sweep"},
      {2304, 2431, 1, 6, "pillars", "fov twist"},
      {2432, 2559, 1, 7, "pillars", "ray pattern"},
      {2560, 2687, 2, 0, "tunnel", "full ray pattern"},
      {2688, 2815, 2, 1, "tunnel", "full ray pattern"},
      {2816, 2943, 3, 2, "heights", "full ray pattern"},
      {2944, 3071, 3, 3, "heights", "full ray pattern"},
      {3072, 3199, 4, 4, "heights and pillars", "ray pattern"},
      {3200, 3327, 4, 5, "heights and pillars", "ray pattern"},
      {3328, 3455, 1, 6, "pillars", "ray pattern"},
      {3456, 3583, 1, 7, "pillars", "ray pattern"},
      {3584, 3711, 6, 0, "narrow tunnel", "ray pattern"},
      {3712, 3839, 6, 1, "narrow tunnel", "ray pattern"},
      {3840, 3967, 7, 2, "narrow heights", "ray pattern"},
      {3968, 4095, 7, 3, "narrow heights", "ray pattern"},
      {4096, 6143, 2, 0, "tunnel", ""},
      {6144, 8191, 3, 0, "heights", ""},
      {8192, 8319, 0, 0, "pillars", ""},
      {8320, 8447, 0, 1, "pillars", "yaw twist, inverse"},
      {8448, 8575, 1, 2, "pillars", "twist"},
      {8576, 8703, 1, 3, "pillars", "double twist, inverse"},
      {8704, 8831, 2, 6, "tunnel", "fov twist"},
      {8832, 8959, 2, 7, "tunnel", "fov twist"},
      {8960, 9087, 3, 4, "heights", "fov sweep"},
      {9088, 9215, 3, 5, "heights", "fov sweep"},
      {9216, 9343, 4, 0, "heights and pillars", ""},
      {9344, 9471, 4, 1, "heights and pillars", "yaw twist"},
      {9472, 9599, 5, 2, "portals", "twist, fast"},
      {9600, 9727, 5, 3, "portals", "double twist, fast"},
      {9728, 9855, 6, 6, "narrow tunnel", "fov twist"},
      {9856, 9983, 6, 7, "narrow tunnel", "fov twist"},
      {9984, 10111, 7, 4, "narrow heights", "fov sweep"},
      {10112, 10239, 7, 5, "narrow heights", "fov sweep"},
      {10240, 12287, 5, 0, "portals", ""},
      {12288, 12798, 6, 0, "narrow tunnel", ""},
  };
  return parts;
}

std::string DemoPart::name() const {
  return *effects ? std::string(scene) + ", " + effects : scene;
}

const DemoPart& demo_part(int frame) {
  const auto& parts = demo_parts();
  const auto found = std::find_if(parts.begin(), parts.end(), [=](const DemoPart& part) {
    return frame >= part.first_frame && frame <= part.last_frame;
  });
  if (found == parts.end())
    throw std::out_of_range("the demo has no frame " + std::to_string(frame));
  return *found;
}

}  // namespace racebeam
