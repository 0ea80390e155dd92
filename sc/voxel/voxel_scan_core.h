// Behaviour of voxel_scan (voxel_scan.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/voxel/codes.h"
#include "sc/voxel/knobs.h"

namespace racebeam {

struct voxel_scan_core {
  int state_q = VoxelScanIdle;
  int row_q = 0, column_q = 0;

  struct inputs {
    bool rst_n, start, ray_done;
    int kind;
    bool done, put_ready;
  };
  struct outputs {
    bool picture_done, camera_start, next_pixel, next_line;
    bool start, shadow;
    int max_outer, max_inner;
    bool take, shade, shadowed;
    bool put_valid;
    int put_address;
  };

  outputs comb(const inputs& in, const voxel_knobs& k) const {
    outputs o{};
    const bool last_of_line = column_q == k.picture_width - 1;
    const bool last = last_of_line && row_q == k.picture_height - 1;
    const bool lit = k.shadows && in.kind == VoxelHit;  // unless something is in the way
    switch (state_q) {
      case VoxelScanIdle: o.start = o.camera_start = in.start; break;
      case VoxelScanRay:
        o.take = in.ray_done;
        o.start = in.ray_done && lit;
        o.shade = in.ray_done && !lit;
        break;
      case VoxelScanShadow:
        o.shade = in.ray_done;
        o.shadowed = in.ray_done && in.kind == VoxelHit;
        break;
      default: {
        o.put_valid = in.done;
        const bool ends = in.done && in.put_ready;
        o.picture_done = ends && last;
        o.next_line = ends && last_of_line && !last;
        o.next_pixel = ends && !last_of_line;
        o.start = ends && !last;
      }
    }
    o.shadow = state_q == VoxelScanRay;
    o.max_outer = o.shadow ? k.shadow_outer : k.max_outer;
    o.max_inner = o.shadow ? k.shadow_inner : k.max_inner;
    o.put_address = row_q << VoxelPlaceBits | column_q;
    return o;
  }

  /// A clock with these inputs changes nothing.
  bool idle(const inputs& in) const {
    if (!in.rst_n) return false;
    if (state_q == VoxelScanIdle) return !in.start;
    return state_q == VoxelScanShade ? !in.done || !in.put_ready : !in.ray_done;
  }
  void clock(const inputs& in, const voxel_knobs& k) {
    const outputs o = comb(in, k);
    if (o.shade) state_q = VoxelScanShade;
    else if (o.start) state_q = o.shadow ? VoxelScanShadow : VoxelScanRay;
    else if (o.picture_done) state_q = VoxelScanIdle;
    if (o.next_pixel) ++column_q;
    if (o.next_line || o.picture_done) column_q = 0;
    if (o.next_line) ++row_q;
    if (o.picture_done) row_q = 0;
    if (!in.rst_n) *this = {};
  }

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("state_q", VoxelScanStateBits, [this] { return state_q; });
    visit("row_q", VoxelRowBits, [this] { return row_q; });
    visit("column_q", VoxelPlaceBits, [this] { return column_q; });
  }
};

}  // namespace racebeam
