// Histogram: how many pixels or clocks of some frames had each value.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace racebeam {

/// The sum over `frames` frames.
struct Histogram {
  std::int64_t frames = 0;
  std::vector<std::int64_t> bins;

  void add(std::int64_t more_frames, const std::vector<std::int64_t>& more);
};

/// Bins as a store keeps them: 64 bits each, the lowest byte first.
std::string bytes_of(const std::vector<std::int64_t>& bins);
std::vector<std::int64_t> bins_of(const std::string& bytes);

}  // namespace racebeam
