// The `tlm` level of the block renderer on the bench: its cores in one loop, and a host that is
// plain code.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/block/block_machine.h"
#include "tb/bench/block_bench.h"

namespace racebeam {

class BlockTlmBench final : public ChipBench {
 public:
  /// The scene outlives it.
  BlockTlmBench(const WiredBench::Setting& setting, const BenchWishes& wishes);

  void seek(int picture) override;
  Frame render() override;
  std::uint64_t clocks() const override {
    return static_cast<std::uint64_t>(machine_.store().clock());
  }
  const SoundMonitor* sound() const override { return nullptr; }

  /// As block_machine has it.
  void note(block_renderer::notes* to) { machine_.note(to); }
  /// The frame store with all words of the picture that was rendered last, by address.
  std::vector<std::uint64_t> words() const { return machine_.picture(); }

 private:
  const BlockProgram& program_;
  const block_knobs knobs_;
  const BenchWishes wishes_;
  const int pictures_;  // of the show
  block_machine machine_;
  BlockMotion motion_;
  LoadBar bar_;
  int next_ = 0;
};

/// BenchKind::pixels.
PixelClocks block_pixels(const WiredBench::Setting& setting, int picture);

}  // namespace racebeam
