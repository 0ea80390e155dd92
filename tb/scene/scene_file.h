// SceneFile: a scene of the interval tracer as its author wrote it, after reading: rooms, portals,
// camera, look, timeline.
//
// Axes as on the chip: x east, y down, z north; the camera looks north at yaw 0. Units are the
// chip's: a pillar of its first scene is 256 wide.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tb/scene/place.h"

namespace racebeam {

constexpr int FaceCount = 6;
constexpr int PortalsPerFace = 4;  ///< at most
constexpr int VisibleRooms = 8;    ///< portals that a ray passes at most
constexpr int MaxRooms = 8191;     ///< 13 bits; the id with all bits set means solid
constexpr int MaxCornerBits = 16;
constexpr int MinCornerBits = 10;
constexpr int MaxFrames = 16383;  ///< the frame counter has 14 bits; its last value ends a loop
constexpr int TurnUnits = 2048;   ///< angle units in a full turn
constexpr int FocalUnits = 256;   ///< the focal length counts modulo this

using Vector = std::array<int, 3>;  ///< x, y, z

/// 2 * axis + (towards negative coordinates ? 1 : 0).
enum Face { East, West, Down, Up, North, South };
/// "east" ...
const char* face_name(int face);
inline int face_axis(int face) { return face / 2; }
inline int opposite(int face) { return face ^ 1; }

struct Room {
  std::string id;
  std::string set;  ///< rooms of different sets may stand in the same place and do not connect
  Vector centre{}, half_size{};
  std::array<std::vector<int>, FaceCount> portals{};  ///< rooms behind each face; empty: solid
  Place place{};

  int low(int axis) const { return centre[axis] - half_size[axis]; }
  int high(int axis) const { return centre[axis] + half_size[axis]; }
};

/// Whether they share some space.
bool rooms_overlap(const Room& a, const Room& b);
/// Whether the face of `a` and the opposite face of `b` have an area in common.
bool rooms_touch(const Room& a, int face, const Room& b);

/// A number that moves: start + step * floor(frames / every) + per_line * y.
struct Turn {
  int start = 0;     ///< at frame `since`
  int step = 0;      ///< added ...
  int every = 1;     ///< ... after each so many frames
  int per_line = 0;  ///< added for each line below the middle of the picture
  int since = 0;     ///< frame of the shot that set it

  /// At a frame and a line (y = -240..239), modulo `units`.
  int value(int frame, int y, int units) const;
};

struct Camera {
  int room = 0;
  Vector position{};  ///< from the centre of the room
  Vector velocity{};  ///< per frame
  Turn yaw{}, pitch{};
  Turn fov{96};            ///< focal length in pixels; the picture is 640 wide
  bool interlace = false;  ///< odd lines show z one unit back
};

enum class Shading { Axis, Dithered };
/// The ray direction itself as a picture, instead of the scene: in some lines, or all over.
enum class Pattern { Off, Partial, Full };

using Palette = std::array<std::uint8_t, 4>;  ///< r * 16 + g * 4 + b, 2 bits each

struct Look {
  Palette palette{0, 1, 6, 43};             ///< the chip's palette 0
  Palette pattern_palette{17, 37, 57, 62};  ///< where the pattern is shown; palette 2
  Shading shading = Shading::Axis;
  Pattern pattern = Pattern::Off;
  bool inverse = false;  ///< swaps colours 2 and 3
};

/// Everything that holds from `frame` on, until the next shot.
struct Shot {
  int frame = 0;
  std::string name;     ///< as the author calls it, or empty
  bool restart = true;  ///< the camera jumps to camera.room, camera.position
  Camera camera{};
  Look look{};
  Place place{};
};

struct SceneFile {
  std::string name;
  int frames = 0;           ///< length of the timeline
  int corner_bits = 0;      ///< as the author wants it; 0: as many as needed
  bool wrap = false;        ///< far corners may exceed corner_bits, as on the chip
  bool overlap = false;     ///< rooms may overlap and portals may lead anywhere
  std::vector<Room> rooms;  ///< the index is the room's number
  std::vector<Shot> shots;  ///< by frame; the first is [camera] and [look], frame 0

  /// The shot that holds at a frame.
  const Shot& shot_at(int frame) const;
};

/// Makes `b` a neighbour behind `face` of `a`, and `a` of `b`. Once is enough.
void connect(std::vector<Room>& rooms, int a, int face, int b);
/// Portals, each counted once.
int count_portals(const SceneFile& scene);

}  // namespace racebeam
