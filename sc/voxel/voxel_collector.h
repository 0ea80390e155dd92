// voxel_collector: counts a picture of the wired chip from its wires, as voxel_machine does.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/voxel/counters.h"
#include "sc/voxel/knobs.h"

namespace racebeam {

/// The wires of a clock, settled.
struct voxel_wires {
  bool sends;                   ///< the host has a colour or a column
  std::uint64_t build_columns;  ///< of a rectangle whose building begins
  int builder_state, scan_state, walker_state;
  int level;         ///< where the ray is
  bool fetch;        ///< of a word of occupancy
  bool sample;       ///< that ends
  bool column_read;  ///< by the leaf or the shader
  bool ray_done;
  int kind;
  store_view store;
};

class voxel_collector {
 public:
  explicit voxel_collector(const voxel_knobs& k) : store_knobs_(k.store()) {}
  void observe(const voxel_wires& w);
  /// While no picture is drawn: what was counted since the last one is forgotten.
  void begin() { now_ = {}; }
  /// Pictures that are done.
  int pictures() const { return pictures_; }
  /// The one that was done last.
  const voxel_counters& last() const { return last_; }

 private:
  void count_walker(const voxel_wires& w);
  void count_ray(const voxel_wires& w);

  const store_knobs store_knobs_;
  voxel_counters now_, last_;
  int pictures_ = 0;
  int scan_state_ = VoxelScanIdle;  // of the clock before
  int moved_from_ = -1;             // the level that a ray left; -1: it has not moved since
  bool read_ = false;               // a word, for the voxel that is looked at
  bool frame_begins_ = true;
};

}  // namespace racebeam
