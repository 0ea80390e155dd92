// Behaviour of voxel_shade (voxel_shade.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "sc/base/probe.h"
#include "sc/voxel/voxel_colour.h"

namespace racebeam {

struct voxel_shade_core {
  enum step { Idle = 0, Own = 1, East = 2, West = 3, North = 4, South = 5, Last = 6 };
  int step_q = Idle;
  int phase_q = 0;  // clocks of this read that are over
  int kind_q = VoxelSky;
  vec3 cell_q{};  // where the ray ended, in whole units
  std::uint32_t column_q = 0;
  int slope_q = 0;  // 2 (east - west) + (north - south), of what is read
  bool shadowed_q = false;
  voxel_palette palette_q{};

  struct inputs {
    bool rst_n;
    bool palette_write;
    int palette_index, palette_colour;
    bool take, shade, shadowed;
    int kind;
    vec3 hit;
    int direction_z;
    bool leaf_read;
    std::uint32_t leaf_address, data;
    bool put_ready;
  };
  struct outputs {
    bool read;
    std::uint32_t address;
    bool done;
    int colour;
  };

  outputs comb(const inputs& in, const voxel_knobs& k) const;
  /// A clock with these inputs changes nothing.
  bool idle(const inputs& in) const {
    return step_q == Idle && !in.take && !in.shade && !in.palette_write;
  }
  void clock(const inputs& in, const voxel_knobs& k);

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("step_q", 3, [this] { return step_q; });
    visit("phase_q", 4, [this] { return phase_q; });
    visit("kind_q", VoxelKindBits, [this] { return kind_q; });
    for (std::size_t n = 0; n < 3; ++n)
      visit(std::string("cell_") + "xyz"[n] + "_q", VoxelCoordinateBits,
            [this, n] { return cell_q[n]; });
    visit("column_q", VoxelMemoryBits, [this] { return column_q; });
    visit("slope_q", 11, [this] { return slope_q; });
    visit("shadowed_q", 1, [this] { return shadowed_q; });
    for (int n = 0; n < VoxelPaletteEntries; ++n)
      visit(element("palette_q", n), VoxelColourBits,
            [this, n] { return palette_q[static_cast<std::size_t>(n)]; });
  }

 private:
  bool reads() const { return step_q != Idle && step_q != Last; }
  voxel_surface surface(const inputs& in) const {
    return voxel_surface_of(unpacked_column(column_q), cell_q[2], in.direction_z < 0);
  }
  int colour(const inputs& in, const voxel_knobs& k) const;
  std::uint32_t address(const voxel_knobs& k) const;
  int next_step(const voxel_knobs& k) const;
  void take_column(const inputs& in);
};

}  // namespace racebeam
