// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/starter_scene.h"

namespace racebeam {

const char* starter_scene() {
  return R"(# A scene for racebeam. Look at it: racebeam scene plan FILE -o plan.png
name = "first steps"
frames = 600                 # ten seconds

[plan]
cell = 192                   # edge of a cell; a character is one cell
height = 384
# North is up. '#' is solid, '.' open, '@' where the camera starts; letters are described below.
storeys = """
#######
#..L..#
#.#.#.#
#..L..#
#.#.#.#
#..@..#
#######
"""

[plan.cells]
L = { height = 512, skylight = true }

[camera]
position = [0, 64, -64]      # from the middle of the room: x east, y down, z north
velocity = [0, 0, 1]         # per frame
yaw = { step = 2, every = 3 }  # 2048 is a full turn
pitch = { start = -40 }

[look]
palette = ["000", "110", "231", "332"]  # red, green, blue 0..3: unlit, north, floor, east

[[shot]]                     # from frame 360 on
frame = 360
camera = { yaw = { step = -4 }, fov = { start = 96, step = 1, every = 4 } }
look = { shading = "dithered" }
)";
}

}  // namespace racebeam
