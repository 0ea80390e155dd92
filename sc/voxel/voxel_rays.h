// voxel_rays: how a ray goes through the octree, as a plain loop: voxel_setup, voxel_walker,
// voxel_leaf and voxel_limits in one piece, with their clocks.
//
// A ray stands in a voxel of some level. If nothing is in it, the ray goes on to the border that it
// leaves by, and to the larger voxel behind it if the border is one of its too. If something is,
// it goes down; in the smallest voxel the columns are sampled at fixed steps.
//
// Source: article "Algorithm", "Termination".
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "sc/voxel/numbers.h"
#include "sc/voxel/voxel_world.h"

namespace racebeam {

struct voxel_ray {
  vec3 origin{};     ///< 16.8
  vec3 direction{};  ///< 2.16
};

/// Steps that a ray may take.
struct voxel_limit {
  int outer, inner;
};

/// What rays cost.
struct voxel_walked {
  std::array<std::uint64_t, VoxelMaxLevels> fetches_by_level{};  ///< bits of occupancy looked at
  std::array<std::uint64_t, VoxelMaxLevels> words_by_level{};    ///< of them read from the memory
  std::uint64_t moves = 0;                                       ///< to the next voxel
  std::uint64_t descents = 0;                                    ///< to a child
  std::uint64_t raises = 0;  ///< to a container, at a border of it
  std::uint64_t samples = 0;
  std::uint64_t column_reads = 0;
  std::uint64_t clocks = 0;  ///< of the walker

  std::uint64_t fetches() const;
  std::uint64_t words() const;
};

/// Where a ray ended.
struct voxel_end {
  voxel_kind kind = VoxelSky;
  std::int64_t t = 0;  ///< 24.8
  vec3 position{};     ///< 16.8; of the sky: not set
};

/// What a ray did: for those who look on.
struct voxel_step {
  enum deed { Empty, Down, Sample, Hit, Leave };
  int level;
  vec3 voxel;
  voxel_place place;
  std::int64_t t, t_out;  ///< t_out: of a voxel that is left
  deed done;
};
using voxel_steps = std::function<void(const voxel_step&)>;

/// Walks a ray; adds what it cost.
voxel_end voxel_walk(const voxel_world& world, const voxel_knobs& k, const voxel_ray& ray,
                     const voxel_limit& limit, voxel_walked& walked,
                     const voxel_steps* steps = nullptr);

}  // namespace racebeam
