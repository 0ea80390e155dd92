// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/voxel_machine.h"

#include "sc/voxel/voxel_build.h"
#include "sc/voxel/voxel_scan.h"
#include "sc/voxel/voxel_tracer.h"

namespace racebeam {

voxel_machine::voxel_machine(const voxel_knobs& k)
    : knobs_(k), store_(k.store(), voxel_knobs::clocks_per_pixel), world_(voxel_levels(k)) {}

void voxel_machine::go_to_frame() {
  const std::int64_t frame = store_.frame_clocks();
  go_to((store_.clock() + frame - 1) / frame * frame);
}

void voxel_machine::send() {
  go_to(store_.clock() + 1);
  ++next_.host_clocks;
}

void voxel_machine::write_colour(int index, int rgb) {
  palette_[static_cast<std::size_t>(index)] = rgb;
  send();
}

void voxel_machine::write_column(std::uint32_t address, std::uint32_t word) {
  world_.columns()[address] = word;
  send();
}

void voxel_machine::build(const voxel_rectangle& rectangle) {
  constexpr int StartClocks = 1;
  const voxel_built built = voxel_build(world_, rectangle, knobs_.memory_clocks);
  go_to(store_.clock() + StartClocks + static_cast<std::int64_t>(built.clocks));
  next_.build_clocks += built.clocks;
  next_.build_columns += built.columns;
  ++next_.rectangles;
}

void voxel_machine::deposit(const std::vector<std::uint32_t>& columns) {
  world_.columns() = columns;
  world_.build();
  next_ = {};
}

void voxel_machine::draw(const voxel_view& view) {
  constexpr int StartClocks = 1;
  go_to(store_.clock() + StartClocks);
  counters_ = next_;
  next_ = {};
  const std::int64_t start = store_.clock();
  const voxel_tracer tracer(knobs_, world_, palette_);
  if (begins_) begins_->clear();
  for (int y = 0; y < knobs_.picture_height; ++y)
    for (int x = 0; x < knobs_.picture_width; ++x) {
      if (begins_) begins_->push_back(store_.clock());
      const voxel_drawn pixel = tracer.draw(view, x, y, counters_);
      store_.go_to(store_.clock() + pixel.clocks - 1, &counters_);
      store_.put(y << VoxelPlaceBits | x, static_cast<std::uint64_t>(pixel.colour), counters_);
    }
  const std::int64_t end = store_.clock();
  counters_.clocks = static_cast<std::uint64_t>(end - start);
  counters_.store_reads = store_.reads_before(end) - store_.reads_before(start);
  counters_.frames = store_.frames_before(end) - store_.frames_before(start);
}

}  // namespace racebeam
