// Behaviour of voxel_builder (voxel_builder.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/voxel/voxel_build.h"
#include "sc/voxel/voxel_levels.h"

namespace racebeam {

struct voxel_builder_core {
  explicit voxel_builder_core(const voxel_knobs& k) : levels(k) {}

  const voxel_levels levels;

  int state_q = VoxelBuilderIdle;
  bool known_q = false;  // FILL: the column is there
  bool puts_q = false;   // a bit is read to be written
  int phase_q = 0;       // clocks of an access that are over
  int level_q = 0;
  voxel_rectangle area_q{};       // in voxels of the level
  int x_q = 0, y_q = 0, z_q = 0;  // the voxel; in FILL x and y of the column
  int child_q = 0;                // UP: that is looked at
  bool found_q = false;           // and the last one was occupied
  int low_q = 0, middle_q = 0, high_q = 0;
  std::uint32_t columns_q = 0;

  struct inputs {
    bool rst_n;
    voxel_rectangle rectangle;
    bool start, host_write;
    std::uint32_t host_address;
    bool walk_read;
    std::uint32_t walk_address;
    bool leaf_read;
    std::uint32_t leaf_address;
    std::uint32_t column, occupancy;  // of the memories
  };
  struct outputs {
    bool done;
    bool column_read, column_write;
    std::uint32_t column_address;
    bool occupancy_read, occupancy_write;
    std::uint32_t occupancy_address, occupancy_data;
  };

  /// With these inputs no register changes.
  bool idle(const inputs& in) const {
    return state_q == VoxelBuilderIdle && in.rst_n && !takes(in);
  }
  outputs comb(const inputs& in, const voxel_knobs& k) const;
  void clock(const inputs& in, const voxel_knobs& k);

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit) const {
    constexpr int Place = VoxelRectangleBits, Height = VoxelHeightBits;
    visit("state_q", VoxelBuilderStateBits, [this] { return state_q; });
    visit("known_q", 1, [this] { return known_q; });
    visit("puts_q", 1, [this] { return puts_q; });
    visit("phase_q", 4, [this] { return phase_q; });
    visit("level_q", VoxelLevelBits, [this] { return level_q; });
    visit("x_low_q", Place, [this] { return area_q.x_low; });
    visit("y_low_q", Place, [this] { return area_q.y_low; });
    visit("x_high_q", Place, [this] { return area_q.x_high; });
    visit("y_high_q", Place, [this] { return area_q.y_high; });
    visit("x_q", Place, [this] { return x_q; });
    visit("y_q", Place, [this] { return y_q; });
    visit("z_q", Height, [this] { return z_q; });
    visit("child_q", 3, [this] { return child_q; });
    visit("found_q", 1, [this] { return found_q; });
    visit("low_q", Height, [this] { return low_q; });
    visit("middle_q", Height, [this] { return middle_q; });
    visit("high_q", Height, [this] { return high_q; });
    visit("columns_q", 32, [this] { return columns_q; });
  }

 private:
  bool takes(const inputs& in) const {
    return state_q == VoxelBuilderIdle && in.start && voxel_buildable(in.rectangle, levels.size());
  }
  bool fetches() const { return state_q == VoxelBuilderFill && !known_q; }
  bool looks() const { return state_q == VoxelBuilderUp && !puts_q; }
  /// A height of a column is compared.
  bool compares() const { return state_q == VoxelBuilderFill && known_q && !puts_q; }
  bool solid() const;
  voxel_place place() const;
  voxel_rectangle limits() const;
  /// The last clock of an access.
  bool ends(const voxel_knobs& k) const { return phase_q == k.memory_clocks; }
  /// The last clock of a voxel; and of the last one.
  bool leaves(const voxel_knobs& k) const { return compares() ? !solid() : puts_q && ends(k); }
  bool last() const;
  void go_on();
  void begin(int state, int level, const voxel_rectangle& area);
};

}  // namespace racebeam
