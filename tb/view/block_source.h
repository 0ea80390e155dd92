// BlockSource: the block renderer and its host as a source of pictures.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sc/block/block_machine.h"
#include "tb/host/block_program.h"
#include "tb/host/load_bar.h"
#include "tb/view/sources.h"
#include "tb/view/store_source.h"

namespace racebeam {

class BlockSource : public StoreSource {
 public:
  /// Stands before picture 0 of `pictures`. The program outlives it.
  BlockSource(const BlockProgram& program, const block_knobs& k, int pictures);

  bool plain() const override { return true; }

 private:
  void restart() override;
  std::vector<std::uint64_t> draw() override;
  void skip() override;
  int picture_rows() const override { return knobs_.rows(); }
  std::uint64_t picture_clocks() const override;
  frame_counts counts() const override { return counted(machine_->counters()); }
  const std::vector<counter_info>& counter_infos() const override;
  void finish(PackedPicture& picture) override;

  const BlockProgram& program_;
  const block_knobs knobs_;
  std::optional<block_machine> machine_;
  std::optional<BlockMotion> motion_;
  LoadBar bar_;
};

/// The row of sources().
SourceKind block_sources();

}  // namespace racebeam
