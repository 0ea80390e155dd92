// Frames spread evenly over a show.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

namespace racebeam {

/// The middles of `count` parts of equal length of `frames` frames; all frames if there are no
/// more.
inline std::vector<int> spread_frames(int frames, int count) {
  count = std::min(count, frames);
  std::vector<int> spread;
  for (int i = 0; i < count; ++i)
    spread.push_back(static_cast<int>((2LL * i + 1) * frames / (2 * count)));
  return spread;
}

}  // namespace racebeam
