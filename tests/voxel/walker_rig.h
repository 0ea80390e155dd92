// The cores that a ray goes through, wired in a plain loop with both memories, a clock at a time.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>

#include "sc/voxel/voxel_address_core.h"
#include "sc/voxel/voxel_leaf_core.h"
#include "sc/voxel/voxel_limits_core.h"
#include "sc/voxel/voxel_rays.h"
#include "sc/voxel/voxel_setup_core.h"
#include "sc/voxel/voxel_walker_core.h"

namespace racebeam {

/// A memory whose word is there `clocks` after the clock of its address.
class SlowMemory {
 public:
  SlowMemory(const std::vector<std::uint32_t>& words, int clocks)
      : words_(words), later_(static_cast<std::size_t>(clocks)) {}
  void clock(bool read, std::uint32_t address) {
    later_.push_back(read ? words_[address] : later_.back());
    later_.pop_front();
  }
  std::uint32_t data() const { return later_.front(); }

 private:
  const std::vector<std::uint32_t>& words_;
  std::deque<std::uint32_t> later_;
};

class WalkerRig {
 public:
  WalkerRig(const voxel_world& world, const voxel_knobs& k)
      : knobs_(k),
        walker(k),
        address_(k),
        bits_(world.occupancy(), k.memory_clocks),
        columns_(world.columns(), k.memory_clocks) {}

  /// As voxel_walk(); `hit` has no t.
  voxel_end walk(const voxel_ray& ray, const voxel_limit& limit, voxel_walked& walked) {
    bool start = true;
    for (int clocks = 0; clocks < 1'000'000; ++clocks) {
      voxel_walker_core::inputs in{};
      in.rst_n = true;
      in.start = start;
      in.origin = ray.origin;
      in.direction = ray.direction;
      for (int axis = 0; axis < 3; ++axis)
        in.inverse[static_cast<std::size_t>(axis)] = setup_.inverse(axis, walker.direction_q);
      voxel_leaf_core::inputs leaf{};
      leaf.rst_n = true;
      leaf.origin = walker.origin_q;
      leaf.direction = walker.direction_q;
      leaf.step = walker.leaf_step_q;
      leaf.data = columns_.data();
      // Until what goes around between them is settled.
      voxel_walker_core::outputs o{};
      voxel_leaf_core::outputs l{};
      voxel_limits_core::inputs limits{start, false, false, limit.outer, limit.inner};
      for (int turn = 0; turn < 4; ++turn) {
        o = walker.comb(in, knobs_);
        leaf.start = o.leaf;
        leaf.at = o.at;
        leaf.fetch = o.column;
        leaf.t_from = o.t;
        leaf.t_to = o.t_out;
        l = leaf_.comb(leaf, knobs_);
        limits.outer = o.outer;
        limits.inner = o.inner;
        in.some = l.some;
        in.sample = l.sample;
        in.hit = l.hit;
        in.done = l.done;
        in.position = l.position;
        in.reached = leaf.stop = limits_.reached(limits);
      }
      const voxel_place place = address_.comb(o.voxel[0], o.voxel[1], o.voxel[2], o.level);
      in.inside = place.inside;
      in.bit = place.bit;
      in.data = bits_.data();
      const voxel_end end{static_cast<voxel_kind>(o.kind), 0, o.hit};
      if (!start) ++walked.clocks;
      count(o, l, walked);
      setup_.clock({true, o.setup, walker.direction_q});
      walker.clock(in, knobs_);
      leaf_.clock(leaf, knobs_);
      limits_.clock(limits);
      bits_.clock(o.read, place.word);
      columns_.clock(l.read, l.address);
      start = false;
      if (o.ray_done) return end;
    }
    throw std::runtime_error("a ray that does not end");
  }

 private:
  void count(const voxel_walker_core::outputs& o, const voxel_leaf_core::outputs& l,
             voxel_walked& walked) {
    const auto level = static_cast<std::size_t>(walker.level_q);
    if (walker.state_q == VoxelFetch && walker.step_q == 0) ++walked.fetches_by_level[level];
    if (o.read) ++walked.words_by_level[level];
    walked.descents += walker.state_q == VoxelDown;
    walked.moves += walker.state_q == VoxelMove;
    walked.samples += l.sample;
    walked.column_reads += l.read;
  }

  const voxel_knobs knobs_;

 public:
  voxel_walker_core walker;

 private:
  voxel_address_core address_;
  voxel_setup_core setup_;
  voxel_leaf_core leaf_;
  voxel_limits_core limits_;
  SlowMemory bits_, columns_;
};

}  // namespace racebeam
