// What the block renderer counts in a picture.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sc/base/frame_counts.h"
#include "sc/block/codes.h"
#include "sc/store/store_counters.h"

namespace racebeam {

constexpr int BlockMaxPasses = 8, BlockCorners = 4;

/// Of all cores.
struct block_counters : store_counters {
  std::uint64_t clocks = 0;       ///< from the first job dealt until all cores are in IDLE
  std::uint64_t host_clocks = 0;  ///< in which the host sent the scene, before it
  std::uint64_t frames = 0;       ///< of the raster, begun meanwhile
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
  std::uint64_t bus_stalls = 0;  ///< clocks in which a core waited with a word, of all cores
  std::array<std::uint64_t, BlockCores> busy_by_core{};  ///< parts of busy_clocks
};

/// The word of a state in waves: "GROUP"; the code, if it has none.
std::vector<std::string> block_state_words();

/// Rows of the counters and histograms.
std::vector<counter_info> block_counter_infos();
std::vector<histogram_info> block_histogram_infos();
frame_counts counted(const block_counters& counters);

}  // namespace racebeam
