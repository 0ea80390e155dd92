// Back doors of RTL: it gets to a frame or a place through its pins, in clocks of its own.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sc/base/fixed_point.h"

namespace racebeam {

/// Values on inputs, by the ports' names.
using input_values = std::vector<std::pair<const char*, int>>;

/// The same as the back door of sequencer_pins: `edges(inputs, count)` are edges of its own with
/// these inputs, the others as they are.
template <class Edges>
void seek_frame(const Edges& edges, int frame) {
  edges(input_values{{"rst_ni", 0}}, 1);
  edges(input_values{{"rst_ni", 1}, {"frame_end_i", 1}}, frame);
}

/// As that of navigator_pins.
template <class Edges>
void place_camera(const Edges& edges, const vec3& position, int room) {
  edges(input_values{{"rst_ni", 1},
                     {"nav_reset_i", 1},
                     {"start_x_i", position[0]},
                     {"start_y_i", position[1]},
                     {"start_z_i", position[2]},
                     {"start_room_i", room}},
        1);
}

}  // namespace racebeam
