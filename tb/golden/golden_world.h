// The rooms around the camera, and how a frame shows them: what every golden tracer starts from.
//
// The world is input to the tracers, not what they judge: it is read from a scene file, or for the
// demo from the scene table and the sequencer's choices. Room coordinates of the chip wrap modulo
// 2^corner_bits; here each room is placed relative to the neighbour it was found from, in plain
// integers with the camera at the origin, so that an endless tunnel and the far end of the demo's
// grid come out as one consistent space. Rooms that no ray can enter before the depth limit are
// left out.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "sc/base/fixed_point.h"
#include "sc/beam/knobs.h"
#include "tb/scene/camera_path.h"
#include "tb/scene/scene_file.h"

namespace racebeam {

struct GoldenRoom {
  vec3 half_size;  ///< half of the box' edges
  vec3 position;   ///< of the centre, from the camera
  /// By golden_face(): rooms behind the face, in the order in which a ray tries their openings.
  std::array<std::vector<int>, FaceCount> neighbours;
  int id = 0;  ///< the chip's number of the room, or the scene file's
};

/// Index of the face at which a ray leaves along an axis.
constexpr int golden_face(int axis, bool negative) { return 2 * axis + negative; }

/// Does the picture show the ray pattern (contract 17.4): nowhere, where the ray's y component says
/// so, everywhere.
enum class GoldenLock { None, Partial, Full };

struct GoldenWorld {
  /// The world of a frame of the demo, 0..12798. Of the knobs counts what changes the picture that
  /// is meant: max_room_depth, face_stack_depth, corner_bits, interlace, dithering, bisection.
  GoldenWorld(int frame, const knobs& k);

  /// The world of a frame of a scene without faults that `path`, its camera's, reaches.
  /// `k.corner_bits` is the width with which the scene is built.
  GoldenWorld(const SceneFile& scene, const CameraPath& path, int frame, const knobs& k);

  std::vector<GoldenRoom> rooms;  ///< the camera is in the first
  int room_depth;                 ///< rooms entered until the next face counts as a wall
  int corner_bits;                ///< width of the corner under test; 0: unlimited
  int bisection;                  ///< bisection_rule
  bool interlace;                 ///< odd lines show the position one step back
  int dithering;                  ///< dithering_rule: whether shading B alternates, and how
  bool shading_b;                 ///< by axis, side and line parity; else by axis (contract 15.1)
  bool inverse;                   ///< colour indices 2 and 3 change places
  Palette palette;                ///< of the rooms
  Palette pattern_palette;        ///< of the ray pattern
  GoldenLock lock;

  /// What line `y` adds to z of every room: the plain rule of contract 5.4. The residues that the
  /// chip's way back to the root leaves (contract 11.6) are not modelled.
  int offset_z(int y) const { return interlace && (y & 1); }

  /// A corner coordinate as the chip holds it: one that does not fit turns negative.
  int corner(int coordinate) const {
    return corner_bits ? wrap_signed(coordinate, corner_bits) : coordinate;
  }

 private:
  explicit GoldenWorld(const knobs& k);
};

}  // namespace racebeam
