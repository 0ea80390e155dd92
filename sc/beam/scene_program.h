// scene_program: a scene file as the chip holds it: the contents of its two tables.
//
// scene_rom serves the rooms, timeline the shots. Distances are in the chip's units, x right, y
// down, z forward; angles 1/2048 turn.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/base/constants.h"
#include "sc/base/engine.h"
#include "sc/base/fixed_point.h"
#include "sc/beam/knobs.h"

namespace racebeam {

/// A portal in a face of a room: the room behind it, which portal of the opposite face there leads
/// back, and which edges of this room's face lie on or beyond those of the room behind (scene.h,
/// edges_o).
struct portal_row {
  std::uint16_t room = SolidRoom;
  std::uint8_t back = 0;
  std::uint8_t edges = 0;
};

struct room_row {
  vec3 half_size{}, position{};       ///< position of the centre, signed
  portal_row portals[6][MaxPortals];  ///< by face 2 * axis + (towards negative), from portal 0 on
};

/// An angle or focal length: start, and step added after every so many frames.
struct turn_row {
  bool load = false;  ///< this shot sets it; else it goes on, and step and every are repeated here
  int start = 0, step = 0, every = 1;
  int per_line = 0;  ///< times y
};

enum pattern_choice { PatternOff = 0, PatternPartial = 1, PatternFull = 2 };

/// What holds from `frame` on.
struct shot_row {
  int frame = 0;
  bool restart = false;  ///< the camera starts at `start` in `start_room`, and stays for two frames
  int start_room = 0;
  vec3 start{}, velocity{};  ///< room centre minus camera
  turn_row yaw, pitch, fov;
  bool interlace = false, shading_b = false, inverse = false;
  int pattern = PatternOff;
  int colours = 0, pattern_colours = 0;  ///< ColoursBits wide
};

/// The knobs that a scene file sets.
struct program_knobs {
  int corner_bits = CornerBits;
  int navigator_bits = NavigatorPortBits;
  int portals_per_face = 1;  ///< the largest number in any face

  /// `k` with these widths and free flight.
  constexpr knobs fitted(knobs k) const {
    k.corner_bits = corner_bits;
    k.navigator_bits = navigator_bits;
    k.portals_per_face = portals_per_face;
    k.free_flight = 1;
    return k;
  }
};

struct scene_program : scene_tables, program_knobs {
  std::vector<room_row> rooms;
  std::vector<shot_row> shots;  ///< by frame; the first at 0
  int frames = 0;               ///< then it starts again
};

}  // namespace racebeam
