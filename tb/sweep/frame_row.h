// FrameRow: a measured frame, as the store of a sweep keeps it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace racebeam {

/// What is stored of a frame of a point: integers under the names of the sweep's columns.
struct FrameRow {
  int frame = 0;
  bool guard = false;                ///< one of the base point's worst frames: kept out of means
  std::uint64_t digest = 0;          ///< XXH3 of all counters and of the picture's colours
  std::vector<std::int64_t> values;  ///< by column
};

}  // namespace racebeam
