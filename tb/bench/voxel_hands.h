// VoxelHands: what is around the wired voxel tracer: its host.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "sc/voxel/voxel_chip.h"
#include "tb/bench/picture_hands.h"
#include "tb/bench/wired_bench.h"
#include "tb/host/voxel_show.h"

namespace racebeam {

class VoxelHands final : public PictureHands {
 public:
  /// As PictureHands; `program` outlives it, too.
  VoxelHands(voxel_chip& chip, const VoxelProgram& program, const voxel_knobs& k);

  /// The host has no reset: the picture goes on to its end.
  void stop() override { hold(); }
  bool sends() const override {
    return deed_ < deeds_.size() && deeds_[deed_].kind != VoxelDeed::Build;
  }

  /// What was counted of the picture that was done last.
  const voxel_counters& counters() const { return counters_; }

 private:
  void go_to(int picture) override;
  void begin(int picture) override;
  bool send() override;
  void end() override { counters_ = chip_.collector().last(); }

  void put_view();
  void put_deed();
  /// Whether a deed is over with the clock that ends now.
  bool done(const VoxelDeed& deed);

  voxel_chip& chip_;
  VoxelShow show_;
  std::vector<VoxelDeed> deeds_;
  std::size_t deed_ = 0;    // that is done now; after the last the picture is drawn
  std::uint64_t step_ = 0;  // clock of the deed
  bool drawn_ = false;      // the last pixel is put
  voxel_counters counters_;
};

/// BenchKind::around.
std::unique_ptr<Surroundings> make_voxel_hands(wired_chip& chip,
                                               const WiredBench::Setting& setting);

}  // namespace racebeam
