// The camera of a voxel scene and its timeline, and where it is in each picture.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tb/host/voxel_pinhole.h"
#include "tb/scene/table_reader.h"

namespace racebeam {

/// Everything that holds from a picture on, until the next shot.
struct VoxelShot {
  int picture = 0;
  std::string name;  ///< as the author calls it, or empty
  Vector3 position{}, velocity{};
  Turn yaw{}, pitch{114}, fov{320};
  Place place{};  ///< of its camera
};

struct VoxelCamera {
  std::vector<VoxelShot> shots;     ///< by picture; the first is [camera]
  bool given = false;               ///< the file has a [camera]
  std::optional<voxel_view> raw{};  ///< d00, dx and dy, if they are given as they are

  const VoxelShot& shot_at(int picture) const;
  VoxelPinhole pinhole(int picture) const;
};

/// `start`: where it is without a position. `pictures`: how many there are.
VoxelCamera read_voxel_camera(const TomlNode& root, const Vector3& start, int pictures,
                              Faults& faults);

/// Adds the faults of a pinhole: focal length, height.
bool check_pinhole(const VoxelPinhole& pinhole, int picture, Place at, Faults& faults);
/// Adds a fault if a ray of the picture is longer than the tracer can have it.
void check_rays(const voxel_view& view, int width, int height, Place at, Faults& faults);

}  // namespace racebeam
