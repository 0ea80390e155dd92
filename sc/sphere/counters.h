// What the sphere tracer counts in a picture.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "sc/base/frame_counts.h"
#include "sc/sphere/codes.h"
#include "sc/store/store_counters.h"

namespace racebeam {

constexpr int SphereStates = 1 << SphereStateBits;

/// From the first RAY to the last NEXT, unless said otherwise.
struct sphere_counters : store_counters {
  std::uint64_t clocks = 0;
  std::uint64_t host_clocks = 0;  ///< HOST, before it
  std::uint64_t frames = 0;       ///< of the raster, begun meanwhile
  std::uint64_t primary_rays = 0, reflected_rays = 0, shadow_rays = 0;
  std::uint64_t sphere_tests = 0;  ///< of all rays, the light included
  std::uint64_t plane_tests = 0;
  std::uint64_t roots = 0;
  std::uint64_t divisions = 0;  ///< three for a ray, one for a plane that is not turned away
  std::uint64_t hits = 0;       ///< spheres met by primary and reflected rays, also behind others
  std::uint64_t passes = 0;     ///< rays that met something: ADD
  std::uint64_t shadowed = 0;   ///< of the shadow rays
  std::uint64_t black_inside = 0;
  std::uint64_t overflows = 0;    ///< rays of length 64 and more before they are normalised
  std::uint64_t host_faults = 0;  ///< since the picture before
  std::array<std::uint64_t, SphereStates>
      state_clocks{};  ///< by code; both clocks of REFLECT at 22
};

/// The word of a state in waves: "HOST"; the code, if it has none.
std::vector<std::string> sphere_state_words();

/// Rows of the counters, clocks by state among them, and the histogram of the buffer's fill.
std::vector<counter_info> sphere_counter_infos();
std::vector<histogram_info> sphere_histogram_infos();
frame_counts counted(const sphere_counters& counters);

}  // namespace racebeam
