// A picture of the block renderer, block by block.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sc/block/block_rays.h"

namespace racebeam {

/// Draws all blocks, row by row.
class DrawnBlocks {
 public:
  DrawnBlocks(const block_knobs& k, const block_tables& tables)
      : columns_(k.columns()),
        rows_(k.rows()),
        bytes_(static_cast<std::size_t>(columns_ * rows_ * 3)) {
    block_rays rays(k, converted(tables, k));
    for (int y = 0; y < rows_; y += BlockSide)
      for (int x = 0; x < columns_; x += BlockSide) {
        const block_job& job = rays.job(x, y);
        clocks_.push_back(job.clocks);
        for (const block_word& word : job.words) put(word);
      }
    rays.take(counters_);
  }

  const block_counters& counters() const { return counters_; }
  /// Of the block in this column and row of blocks.
  int clocks(int column, int row) const {
    return clocks_.at(static_cast<std::size_t>(row * (columns_ / BlockSide) + column));
  }
  std::array<int, 3> pixel(int x, int y) const {
    const auto at = static_cast<std::size_t>((y * columns_ + x) * 3);
    return {bytes_.at(at), bytes_.at(at + 1), bytes_.at(at + 2)};
  }
  /// FNV-1a over red, green and blue, row by row.
  std::uint32_t checksum() const {
    std::uint32_t hash = 2166136261u;
    for (const std::uint8_t byte : bytes_) hash = (hash ^ byte) * 16777619u;
    return hash;
  }

 private:
  void put(const block_word& word) {
    const int plane_words = columns_ / 8 * rows_;
    const int plane = word.address / plane_words, first = word.address % plane_words * 8;
    for (int n = 0; n < 8; ++n)
      bytes_.at(static_cast<std::size_t>((first + n) * 3 + plane)) =
          static_cast<std::uint8_t>(word.pixels >> 8 * n);
  }

  const int columns_, rows_;
  std::vector<std::uint8_t> bytes_;
  std::vector<int> clocks_;
  block_counters counters_;
};

}  // namespace racebeam
