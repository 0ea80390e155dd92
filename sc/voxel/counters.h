// What the voxel tracer counts in a picture.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sc/base/frame_counts.h"
#include "sc/store/store_counters.h"
#include "sc/voxel/voxel_rays.h"

namespace racebeam {

/// Rays from the eye, and rays to the light, are counted together where nothing else is said.
struct voxel_counters : store_counters {
  std::uint64_t clocks = 0;  ///< from the first pixel on until the last one is put
  std::uint64_t frames = 0;  ///< of the raster, begun meanwhile
  // Before it
  std::uint64_t host_clocks = 0;    ///< in which the host sent colours and columns
  std::uint64_t build_clocks = 0;   ///< in which voxel_builder worked
  std::uint64_t build_columns = 0;  ///< of the rectangles that were built
  std::uint64_t rectangles = 0;     ///< that were built
  // Parts of `clocks`
  std::uint64_t walk_clocks = 0;                         ///< of voxel_walker, for rays from the eye
  std::uint64_t shadow_clocks = 0;                       ///< and to the light
  std::uint64_t shade_clocks = 0;                        ///< of voxel_shade, waiting not among them
  voxel_walked walked;                                   ///< its clocks are not counted here
  std::uint64_t shade_reads = 0;                         ///< of columns, by voxel_shade
  std::array<std::uint64_t, 1 << VoxelKindBits> ends{};  ///< rays from the eye, by voxel_kind
  std::uint64_t shadow_rays = 0;
  std::uint64_t shadowed = 0;  ///< of them: something is between
};

/// The word of a state in waves: "FETCH"; the code, if it has none.
std::vector<std::string> voxel_state_words();
std::vector<std::string> voxel_scan_words();
std::vector<std::string> voxel_builder_words();

/// Rows of the counters and histograms.
std::vector<counter_info> voxel_counter_infos();
std::vector<histogram_info> voxel_histogram_infos();
frame_counts counted(const voxel_counters& counters);

}  // namespace racebeam
