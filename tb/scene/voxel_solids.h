// Scenes of other engines as columns of a voxel world: one storey of rooms, or spheres over a
// floor.
//
// In those files y is down and z away: x = scale x, y = scale z, z = base - scale y. The world
// repeats, so where x = y = 0 is does not matter.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sc/base/fixed_point.h"
#include "tb/host/sphere_program.h"
#include "tb/host/voxel_pinhole.h"
#include "tb/scene/beam_scene.h"
#include "tb/scene/faults.h"

namespace racebeam {

/// How a file's units become the world's.
struct VoxelMapping {
  double scale = 1;
  int base = 0;  ///< the height of y = 0
  vec3 size{};   ///< of the world

  Vector3 place(const Vector3& p) const {
    return {scale * p[0], scale * p[2], base - scale * p[1]};
  }
};

struct VoxelSolids {
  std::vector<std::uint32_t> columns;  ///< as column_memory has them, y * size x + x
  std::vector<int> objects;            ///< VoxelProgram::objects
};

/// The base that puts the lowest floor, or the lowest point of the spheres, at a height.
int base_of_rooms(const std::vector<Room>& rooms, double scale, int floor);
int base_of_spheres(const std::vector<MovingSphere>& spheres, double scale, int floor);

/// In a room a column has low = floor, middle = ceiling, high = the top of the world; others are
/// solid. Objects are walls, as the interval tracer counts them: twelve numbers a room, the first
/// six by Face. Faults are added at `at`: rooms above each other or beyond the world. A warning of
/// rooms that touch without a portal: voxels have no wall without a thickness.
VoxelSolids room_columns(const SceneFile& scene, const VoxelMapping& map, Place at, Faults& faults);

/// A floor of the first material at `floor`, and spheres with `materials`, by sphere. Objects are
/// spheres by number, and the floor as the sphere tracer's first plane. Faults are added at `at`:
/// spheres above each other or beyond the world; they are called by `names`.
VoxelSolids sphere_columns(const std::vector<MovingSphere>& spheres,
                           const std::vector<std::string>& names, const std::vector<int>& materials,
                           int floor, const VoxelMapping& map, Place at, Faults& faults);

/// Where the camera of a scene of rooms is, picture by picture.
std::vector<VoxelPinhole> room_pinholes(const BeamScene& scene, const VoxelMapping& map);
/// The eye of a scene of spheres before its screen.
VoxelPinhole sphere_pinhole(const SphereProgram& program, const VoxelMapping& map);

}  // namespace racebeam
