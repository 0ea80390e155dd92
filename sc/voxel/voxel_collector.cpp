// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_collector.h"

namespace racebeam {

void voxel_collector::count_walker(const voxel_wires& w) {
  // In FETCH the level may be that of the children.
  if (w.walker_state == VoxelFetch) {
    read_ |= w.fetch;
  } else if (moved_from_ >= 0) {
    now_.walked.raises += static_cast<unsigned>(w.level - moved_from_);
    moved_from_ = -1;
  }
  if (w.walker_state == VoxelDown || w.walker_state == VoxelExit) {
    const auto level = static_cast<std::size_t>(w.level);
    ++now_.walked.fetches_by_level[level];
    now_.walked.words_by_level[level] += read_;
    read_ = false;
  }
  if (w.walker_state == VoxelMove) moved_from_ = w.level;
  now_.walked.descents += w.walker_state == VoxelDown;
  now_.walked.moves += w.walker_state == VoxelMove;
  now_.walked.samples += w.sample;
  now_.walked.column_reads += w.column_read;
}

void voxel_collector::count_ray(const voxel_wires& w) {
  const bool shadow = w.scan_state == VoxelScanShadow;
  ++(shadow ? now_.shadow_clocks : now_.walk_clocks);
  if (!w.ray_done) return;
  if (shadow) {
    ++now_.shadow_rays;
    now_.shadowed += w.kind == VoxelHit;
  } else {
    ++now_.ends[static_cast<std::size_t>(w.kind)];
  }
}

void voxel_collector::observe(const voxel_wires& w) {
  now_.host_clocks += w.sends;
  now_.build_clocks += w.builder_state != VoxelBuilderIdle;
  now_.build_columns += w.build_columns;
  now_.rectangles += w.build_columns > 0;
  if (w.scan_state != VoxelScanIdle) {
    ++now_.clocks;
    now_.frames += frame_begins_;
    count(w.store, store_knobs_, now_);
    count_walker(w);
    if (w.scan_state == VoxelScanShade)
      now_.shade_clocks += !(w.store.word_valid && !w.store.word_ready);
    else count_ray(w);
  }
  frame_begins_ = w.store.frame_end;
  const bool over = scan_state_ != VoxelScanIdle && w.scan_state == VoxelScanIdle;
  scan_state_ = w.scan_state;
  if (!over) return;
  last_ = now_;
  now_ = {};
  ++pictures_;
}

}  // namespace racebeam
