// What the block renderer counts in a picture.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "sc/block/codes.h"

namespace racebeam {

constexpr int BlockMaxPasses = 8, BlockCorners = 4;

/// Of all cores.
struct block_counters {
  std::uint64_t clocks = 0;       ///< from the first job dealt until all cores are in IDLE
  std::uint64_t busy_clocks = 0;  ///< outside of IDLE, no wait for the bus among them
  std::uint64_t blocks = 0;
  std::uint64_t cleared = 0;                                 ///< of them: no sphere can be in it
  std::array<std::uint64_t, BlockCorners> kept_by_corner{};  ///< by the first that kept a block
  std::uint64_t groups = 0;                                  ///< of lanes, met by a ray
  std::uint64_t groups_skipped = 0;                          ///< of them: all lanes missed, no NEAR
  std::uint64_t roots = 0;
  std::array<std::uint64_t, BlockMaxPasses> shades{};  ///< by pass
  std::uint64_t small_vectors = 0;                     ///< made unit vectors, shorter than 1/16
  std::uint64_t root_out_of_range = 0;                 ///< roots of 8.0 and above
  std::uint64_t words = 0;
  std::uint64_t bus_stalls = 0;  ///< clocks in which a core waited with a word, of all cores
  std::array<std::uint64_t, BlockCores> busy_by_core{};  ///< parts of busy_clocks
};

}  // namespace racebeam
