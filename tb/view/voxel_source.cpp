// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/voxel_source.h"

#include "sc/voxel/engine.h"

namespace racebeam {

namespace {

constexpr int Bits = 8;  // of a channel in the store

std::unique_ptr<FrameSource> make(const Run& run) {
  return std::make_unique<VoxelSource>(voxel_program_of(run.show.tables()), run.k,
                                       run.show.frames());
}

}  // namespace

VoxelSource::VoxelSource(const VoxelProgram& program, const voxel_knobs& k, int pictures)
    : StoreSource(k.store(), voxel_knobs::clocks_per_pixel, Bits, pictures),
      knobs_(k),
      player_(program, k) {
  begin(player_.machine().picture());
}

std::vector<std::uint64_t> VoxelSource::draw() {
  if (skipped_) player_.seek(next());
  skipped_ = false;
  player_.draw();
  return player_.machine().picture();
}

std::uint64_t VoxelSource::picture_clocks() const {
  const voxel_counters& n = player_.machine().counters();
  return n.clocks + n.host_clocks + n.build_clocks;
}

const std::vector<counter_info>& VoxelSource::counter_infos() const {
  return voxel_engine().counters;
}

SourceKind voxel_sources() { return {voxel_engine(), {LevelTlm}, KeyHelp::Plain, make}; }

}  // namespace racebeam
