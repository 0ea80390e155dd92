// Behaviour of voxel_walker (voxel_walker.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "sc/voxel/numbers.h"
#include "sc/voxel/voxel_levels.h"

namespace racebeam {

struct voxel_walker_core {
  static constexpr int SetupClocks = 18;

  explicit voxel_walker_core(const voxel_knobs& k) : levels(k) {}

  const voxel_levels levels;

  int state_q = VoxelIdle;
  int step_q = 0;  // clocks of SETUP, FETCH or LIMIT that are over
  int level_q = 0, axis_q = 0;
  vec3 voxel_q{};
  std::uint32_t t_q = 0, t_out_q = 0, leaf_step_q = 0;
  vec3 origin_q{}, direction_q{}, hit_q{};
  bool shadow_q = false, occupied_q = false, inner_q = false;
  bool known_q = false;  // children_q has the bits of the voxel's siblings
  int children_q = 0;

  struct inputs {
    bool rst_n, start, shadow;
    vec3 origin, light, direction;
    std::array<std::uint32_t, 3> inverse;
    bool inside;
    int bit;
    std::uint32_t data;
    bool some, sample, hit, done;
    vec3 position;
    bool reached;
  };
  struct outputs {
    bool setup, read, leaf, at, column, outer, inner, ray_done;
    vec3 voxel;
    int level;
    std::uint32_t t, t_out;
    int kind;
    vec3 hit;
  };

  outputs comb(const inputs& in, const voxel_knobs& k) const;
  void clock(const inputs& in, const voxel_knobs& k);

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("state_q", VoxelStateBits, [this] { return state_q; });
    visit("step_q", 5, [this] { return step_q; });
    visit("level_q", VoxelLevelBits, [this] { return level_q; });
    visit("axis_q", 2, [this] { return axis_q; });
    visit("t_q", VoxelTBits, [this] { return t_q; });
    visit("t_out_q", VoxelTBits, [this] { return t_out_q; });
    visit("leaf_step_q", VoxelTBits, [this] { return leaf_step_q; });
    visit("shadow_q", 1, [this] { return shadow_q; });
    visit("occupied_q", 1, [this] { return occupied_q; });
    visit("inner_q", 1, [this] { return inner_q; });
    visit("known_q", 1, [this] { return known_q; });
    visit("children_q", 8, [this] { return children_q; });
    static constexpr const char* names[] = {"x", "y", "z"};
    for (std::size_t n = 0; n < 3; ++n) {
      visit(std::string("voxel_") + names[n] + "_q", VoxelCoordinateBits,
            [this, n] { return voxel_q[n]; });
      visit(std::string("origin_") + names[n] + "_q", VoxelPositionBits,
            [this, n] { return origin_q[n]; });
      visit(std::string("direction_") + names[n] + "_q", VoxelDirectionBits,
            [this, n] { return direction_q[n]; });
      visit(std::string("hit_") + names[n] + "_q", VoxelPositionBits,
            [this, n] { return hit_q[n]; });
    }
  }

 private:
  struct border {
    std::uint32_t t;
    int axis;
  };
  struct moved {
    int level;
    vec3 voxel;
    bool sky, lost;  // above the world for good; where the ray has to stop
  };

  bool down(int axis) const { return direction_q[axis] < 0; }
  std::uint32_t border_t(int axis, int at, const inputs& in) const;
  std::uint32_t entry(const inputs& in) const;
  border leave(const inputs& in) const;
  moved move(const voxel_knobs& k) const;
  /// The memory is asked for the children in the voxel's place.
  bool asks_children(const voxel_knobs& k) const {
    return k.group_fetch && state_q == VoxelFetch && !known_q && level_q > 0;
  }
  bool occupied(const inputs& in, const voxel_knobs& k) const;
  void take_ray(const inputs& in);
  void enter(const inputs& in, const outputs& o, const voxel_knobs& k);
  void descend(const inputs& in);
};

}  // namespace racebeam
