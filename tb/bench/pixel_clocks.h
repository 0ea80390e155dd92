// PixelClocks: when the pixels of a picture are drawn, by an engine that does not race the beam.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace racebeam {

struct PixelClocks {
  int columns, rows;
  std::vector<std::int64_t> begins;  ///< clock of the picture, row by row; one more: its end

  std::size_t number(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(x);
  }
};

}  // namespace racebeam
