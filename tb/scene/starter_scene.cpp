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

const char* starter_sphere_scene() {
  return R"(# A scene of spheres for racebeam. Look at it: racebeam render FILE -o first.png
name = "first spheres"
engine = "sphere"
frames = 120

[eye]
position = [0, 0, -32]       # x right, y down, z away
screen = 8.0                 # the screen stands at z = 256

[light]
position = [15, -15, -1]

[modes]
size = "512x480"             # or "320x240"
reflections = 3
antialias = "none"           # 4x, 8x

[box]                        # what the middles of moving spheres stay in
low = [-15, -15, 5]
high = [15, 15, 35]

[[sphere]]
id = "red"
centre = [-9, 0, 15]
radius = 5
colour = "#ff2121"
reflect = 0.25
velocity = [0.5, 0.125, 0]   # a picture

[[sphere]]
id = "mirror"
centre = [6, 5, 20]
radius = 6
colour = "#303038"
reflect = 0.625

[[plane]]                    # the floor
normal = [0, -1, 0]
distance = 22
colour = "#e8e8e8"
reflect = 0.25
checker = 4

[[input]]                    # the light moves to the left, and the eye sees more
picture = 60
pictures = 10
hold = ["SW16", "KEY1"]
)";
}

const char* starter_block_scene() {
  return R"(# A scene for the block renderer. Look at it: racebeam render FILE -o first.png
name = "first blocks"
engine = "block"
frames = 120

[eye]
position = [0, 0, -7]        # x right, y down, z away

[screen]
size = [8, 6]
z = 0

[light]
position = [-8, -9, -9]

[box]                        # what the middles of moving spheres stay in
low = [-4, -3, 0]
high = [4, 3, 9]

[[sphere]]
id = "large"
centre = [0, 0, 6]
radius = 2.5                 # below 2.828
colour = "#40c080"

[[sphere]]
id = "small"
centre = [-2, -1, 2]
radius = 0.75
colour = [0.75, 0.25, 0.25]  # or parts of full light
velocity = [0.0625, 0.03125, 0.03125]  # a step of time
)";
}

const char* starter_voxel_scene() {
  return R"(# A scene for the voxel tracer. Look at it: racebeam render FILE -o first.png
name = "first hills"
engine = "voxel"
frames = 60

[terrain]
size = [128, 128, 64]        # x right, y away, z up: multiples of the largest voxel
voxel = [1, 4, 1]
function = "hills"           # or picture = "heights.png", rooms or spheres = "FILE.toml"
seed = 7

[camera]
position = [64, 0, 60]       # the world repeats along x and y
pitch = 128                  # down, of 2048 to the turn
velocity = [0, 1, 0]         # a picture

[[crater]]
picture = 30
centre = [64, 90]
radius = 10
depth = 8
)";
}

}  // namespace racebeam
