// block_machine: the block renderer with its host's side and its frame store in one loop, without
// SystemC: the base of the tlm level. The same words, clocks and counters as block_chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/block/block_renderer.h"
#include "sc/store/frame_store.h"

namespace racebeam {

class block_machine {
 public:
  /// After a reset.
  explicit block_machine(const block_knobs& k);

  /// On to the next frame of the raster in whose first clock the write buffer is empty, and the
  /// frame store is made black (back door).
  void await_frame() { store_.await_frame(); }
  /// On to a clock; what is in the write buffer goes on its way.
  void go_to(std::int64_t clock) { store_.go_to(clock, nullptr); }
  /// The host sends a scene, a number a clock, and starts; the picture is drawn.
  void draw(const block_tables& tables);
  /// Of the picture drawn last, and of what the host sent for it.
  const block_counters& counters() const { return counters_; }

  /// As block_renderer::note(); in clocks of the raster.
  void note(block_renderer::notes* to) { notes_ = to; }

  /// The frame store, when all words of the picture are in it, by address.
  std::vector<std::uint64_t> picture() const { return store_.picture(); }
  const frame_store& store() const { return store_; }

  /// Clocks in which the host sends so many spheres.
  static int host_clocks(std::size_t spheres) { return 8 + 10 * static_cast<int>(spheres); }

 private:
  const block_knobs knobs_;
  frame_store store_;
  block_counters counters_;
  block_renderer::notes* notes_ = nullptr;
};

}  // namespace racebeam
