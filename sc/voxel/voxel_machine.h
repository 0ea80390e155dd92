// voxel_machine: the voxel tracer with its builder, its memories, its host's side and its frame
// store in one loop, without SystemC: the base of the tlm level. The same words, clocks and
// counters as voxel_chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/store/frame_store.h"
#include "sc/voxel/counters.h"
#include "sc/voxel/voxel_tables.h"
#include "sc/voxel/voxel_world.h"

namespace racebeam {

class voxel_machine {
 public:
  /// After a reset; nothing is in the memories.
  explicit voxel_machine(const voxel_knobs& k);

  /// On to the next frame of the raster in whose first clock the write buffer is empty, and the
  /// frame store is made black (back door).
  void await_frame() { store_.await_frame(); }
  /// On to a clock; what is in the write buffer goes on its way.
  void go_to(std::int64_t clock) { store_.go_to(clock, nullptr); }
  /// On to the next first clock of a frame, if this is none.
  void go_to_frame();

  /// What the host sends, a clock each.
  void write_colour(int index, int rgb);
  void write_column(std::uint32_t address, std::uint32_t word);
  /// voxel_builder builds a rectangle.
  void build(const voxel_rectangle& rectangle);
  /// The host starts; the picture is drawn.
  void draw(const voxel_view& view);
  /// Of the picture drawn last, and of what was sent and built since the one before it.
  const voxel_counters& counters() const { return counters_; }

  /// Memories as they are once all was built (back door).
  void deposit(const std::vector<std::uint32_t>& columns);

  /// From the pictures drawn from now on: the clock of the raster in which each pixel begins, row
  /// by row.
  void note(std::vector<std::int64_t>* begins) { begins_ = begins; }

  /// The frame store, when all words of the picture are in it, by address.
  std::vector<std::uint64_t> picture() const { return store_.picture(); }
  const frame_store& store() const { return store_; }
  const voxel_world& world() const { return world_; }
  const voxel_palette& palette() const { return palette_; }

 private:
  void send();

  const voxel_knobs knobs_;
  frame_store store_;
  voxel_world world_;
  voxel_palette palette_{};
  voxel_counters counters_, next_;  // of the last picture; what is before the next one
  std::vector<std::int64_t>* begins_ = nullptr;
};

}  // namespace racebeam
