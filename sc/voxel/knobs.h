// What an architect may change of the voxel tracer, and the table that names it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/base/fixed_point.h"
#include "sc/base/knob_values.h"
#include "sc/store/store_knobs.h"

namespace racebeam {

enum voxel_leaf_rule { VoxelLeafMarch = 0, VoxelLeafVoxel = 1 };
enum voxel_raise_rule { VoxelRaiseOne = 0, VoxelRaiseAll = 1 };
enum voxel_shading_rule { VoxelShadingHeight = 0, VoxelShadingSlope = 1 };
enum voxel_sky_rule { VoxelSkyPlain = 0, VoxelSkyGradient = 1 };

struct voxel_knobs {
  int max_outer = 100;
  int max_inner = 100;
  int leaf = VoxelLeafMarch;
  int leaf_steps = 1;
  int levels = 9;
  int raise = VoxelRaiseOne;
  int group_fetch = 0;
  int shading = VoxelShadingHeight;
  int sky = VoxelSkyPlain;
  int shadows = 0;
  int shadow_outer = 20;
  int shadow_inner = 20;
  int debug_limits = 0;
  int build_chunk = 1000000;
  int memory_clocks = 1;
  int write_buffer_depth = 64;
  int write_policy = WritePolicyFree;
  int when_full = WhenFullStall;
  // A scene's.
  int size_x = 64, size_y = 64, size_z = 32;  ///< of the world, in units
  int voxel_x = 1, voxel_y = 4, voxel_z = 1;  ///< of the smallest voxel
  int picture_width = 640, picture_height = 480;

  static constexpr int clocks_per_pixel = 2;  ///< of the raster

  voxel_knobs() = default;
  /// Throws std::logic_error if they are another engine's.
  voxel_knobs(const knob_values& values);  // NOLINT(google-explicit-constructor)
  operator knob_values() const;            // NOLINT(google-explicit-constructor)

  vec3 size() const { return {size_x, size_y, size_z}; }
  vec3 voxel() const { return {voxel_x, voxel_y, voxel_z}; }
  /// Those of the frame store.
  store_knobs store() const {
    store_knobs s;
    s.write_buffer_depth = write_buffer_depth;
    s.write_policy = write_policy;
    s.when_full = when_full;
    s.store_format = StoreRgb888;
    s.picture_width = picture_width;
    s.picture_height = picture_height;
    return s;
  }
};

/// All knobs: a member without a row does not compile.
const std::vector<knob_of<voxel_knobs>>& voxel_knob_table();
/// The same without their places.
const std::vector<knob_row>& voxel_knob_rows();

}  // namespace racebeam
