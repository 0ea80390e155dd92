// A picture of the sphere tracer as one number.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace racebeam {

/// FNV-1a over words of 16 bits, row by row, low byte first; `words` by address {row, column[8:0]}.
inline std::uint32_t picture_checksum(const std::vector<std::uint64_t>& words, int columns,
                                      int rows) {
  std::uint32_t hash = 2166136261u;
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      const auto word = words.at(static_cast<std::size_t>(y << 9 | x));
      for (const auto byte : {word & 255, word >> 8 & 255})
        hash = (hash ^ static_cast<std::uint32_t>(byte)) * 16777619u;
    }
  return hash;
}

}  // namespace racebeam
