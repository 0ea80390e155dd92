// The pinhole of the voxel tracer's host: where it stands and looks becomes the rays of a picture.
//
// x right, y away, z up, as the world; angles in 2048ths of a turn.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/host/ball_motion.h"
#include "tb/host/voxel_program.h"

namespace racebeam {

struct VoxelPinhole {
  Vector3 position{};
  double yaw = 0;    ///< to the right
  double pitch = 0;  ///< down
  double focal_length = 320;
  /// Sines are parabolas, as the interval tracer's camera has them: its pictures are a little bent.
  bool parabolas = false;
  /// From the middle of the picture to the pixel that looks forward, to the right and down.
  double shift_x = 0, shift_y = 0;
};

/// Its rays, through pixels 0..width - 1 and 0..height - 1, the middle of the picture at half of
/// both. They are as long as keeps each component of each below 1. The origin is within the world
/// along x and y: it repeats.
voxel_view pinhole_view(const VoxelPinhole& pinhole, int width, int height, const vec3& size);

/// A direction of length 1, 2.16.
vec3 voxel_light(const Vector3& direction);

}  // namespace racebeam
