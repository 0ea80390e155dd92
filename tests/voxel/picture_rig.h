// The cores that draw a picture, wired in a plain loop with both memories, a clock at a time.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>

#include "sc/voxel/voxel_camera_core.h"
#include "sc/voxel/voxel_scan_core.h"
#include "sc/voxel/voxel_shade_core.h"
#include "tests/voxel/walker_rig.h"

namespace racebeam {

/// What the host says of a picture.
struct PictureView {
  vec3 origin{}, d00{}, dx{}, dy{}, light{};
};

/// What a picture became.
struct DrawnPicture {
  std::map<int, int> colours;  ///< by address
  std::uint64_t clocks = 0;
  std::uint64_t column_reads = 0;
};

class PictureRig {
 public:
  PictureRig(const voxel_world& world, const voxel_knobs& k, const voxel_palette& palette)
      : knobs_(k),
        walker_(k),
        address_(k),
        bits_(world.occupancy(), k.memory_clocks),
        columns_(world.columns(), k.memory_clocks) {
    shade_.palette_q = palette;
  }

  /// `ready`: whether the buffer takes a word in a clock.
  template <class Ready>
  DrawnPicture draw(const PictureView& view, Ready&& ready) {
    DrawnPicture picture;
    wires w = reset(view);
    w.scan.start = true;
    for (bool done = false; !done; ++picture.clocks) {
      if (picture.clocks == 10'000'000) throw std::runtime_error("a picture that does not end");
      w.scan.put_ready = w.shade.put_ready = ready();
      settle(w);
      if (w.shaded.read) ++picture.column_reads;
      if (w.scanned.put_valid && w.scan.put_ready)
        picture.colours[w.scanned.put_address] = w.shaded.colour;
      done = w.scanned.picture_done;
      clock(w);
      w.scan.start = false;
    }
    --picture.clocks;  // that of the host's start
    return picture;
  }

 private:
  struct wires {
    voxel_scan_core::inputs scan{};
    voxel_camera_core::inputs camera{};
    voxel_walker_core::inputs walk{};
    voxel_leaf_core::inputs leaf{};
    voxel_limits_core::inputs limits{};
    voxel_shade_core::inputs shade{};
    voxel_scan_core::outputs scanned{};
    voxel_walker_core::outputs walked{};
    voxel_shade_core::outputs shaded{};
    voxel_place place{};
  };

  static wires reset(const PictureView& view) {
    wires w;
    w.scan.rst_n = w.walk.rst_n = w.leaf.rst_n = w.shade.rst_n = true;
    w.walk.origin = view.origin;
    w.walk.light = view.light;
    w.camera.d00 = view.d00;
    w.camera.dx = view.dx;
    w.camera.dy = view.dy;
    return w;
  }

  /// What goes around between them, until it is settled.
  void settle(wires& w) {
    for (int axis = 0; axis < 3; ++axis)
      w.walk.inverse[static_cast<std::size_t>(axis)] = setup_.inverse(axis, walker_.direction_q);
    w.walk.direction = camera_.direction();
    w.shade.direction_z = w.walk.direction[2];
    w.leaf.origin = walker_.origin_q;
    w.leaf.direction = walker_.direction_q;
    w.leaf.step = walker_.leaf_step_q;
    w.leaf.data = w.shade.data = columns_.data();
    w.walk.data = bits_.data();
    for (int turn = 0; turn < 5; ++turn) {
      w.walked = walker_.comb(w.walk, knobs_);
      w.leaf.start = w.walked.leaf;
      w.leaf.at = w.walked.at;
      w.leaf.fetch = w.walked.column;
      w.leaf.t_from = w.walked.t;
      w.leaf.t_to = w.walked.t_out;
      const voxel_leaf_core::outputs l = leaf_.comb(w.leaf, knobs_);
      w.limits.outer = w.walked.outer;
      w.limits.inner = w.walked.inner;
      w.walk.reached = w.leaf.stop = limits_.reached(w.limits);
      w.walk.some = l.some;
      w.walk.sample = l.sample;
      w.walk.hit = l.hit;
      w.walk.done = l.done;
      w.walk.position = l.position;
      w.scan.ray_done = w.walked.ray_done;
      w.scan.kind = w.shade.kind = w.walked.kind;
      w.shade.hit = w.walked.hit;
      w.shade.leaf_read = l.read;
      w.shade.leaf_address = l.address;
      w.shaded = shade_.comb(w.shade, knobs_);
      w.scan.done = w.shaded.done;
      w.scanned = scan_.comb(w.scan, knobs_);
      w.walk.start = w.limits.start = w.scanned.start;
      w.walk.shadow = w.scanned.shadow;
      w.limits.max_outer = w.scanned.max_outer;
      w.limits.max_inner = w.scanned.max_inner;
      w.shade.take = w.scanned.take;
      w.shade.shade = w.scanned.shade;
      w.shade.shadowed = w.scanned.shadowed;
      w.camera.start = w.scanned.camera_start;
      w.camera.next_pixel = w.scanned.next_pixel;
      w.camera.next_line = w.scanned.next_line;
    }
    const vec3& voxel = w.walked.voxel;
    w.place = address_.comb(voxel[0], voxel[1], voxel[2], w.walked.level);
    w.walk.inside = w.place.inside;
    w.walk.bit = w.place.bit;
  }

  void clock(const wires& w) {
    setup_.clock({true, w.walked.setup, walker_.direction_q});
    scan_.clock(w.scan, knobs_);
    camera_.clock(w.camera);
    walker_.clock(w.walk, knobs_);
    leaf_.clock(w.leaf, knobs_);
    limits_.clock(w.limits);
    shade_.clock(w.shade, knobs_);
    bits_.clock(w.walked.read, w.place.word);
    columns_.clock(w.shaded.read, w.shaded.address);
  }

  const voxel_knobs knobs_;
  voxel_scan_core scan_;
  voxel_camera_core camera_;
  voxel_setup_core setup_;
  voxel_walker_core walker_;
  voxel_address_core address_;
  voxel_leaf_core leaf_;
  voxel_limits_core limits_;
  voxel_shade_core shade_;
  SlowMemory bits_, columns_;
};

}  // namespace racebeam
