// The `signal` level of the block renderer on the bench: a WiredBench with its host, whose pictures
// are those of the frame store.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tb/bench/block_bench.h"
#include "tb/bench/block_hands.h"

namespace racebeam {

class BlockSignalBench final : public WiredBench {
 public:
  /// The scene outlives it. Throws RtlError.
  BlockSignalBench(const Setting& setting, const BenchWishes& wishes);

  void seek(int picture) override;
  /// Throws as WiredBench's.
  Frame render() override;

  /// The frame store with all words of the picture that was rendered last, by address.
  const std::vector<std::uint64_t>& words() const { return hands().memory(); }

 private:
  const BlockHands& hands() const { return static_cast<const BlockHands&>(*around()); }

  const block_knobs knobs_;
  const BenchWishes wishes_;
  const int pictures_;  // of the show
  LoadBar bar_;
  int next_ = 0;
};

}  // namespace racebeam
