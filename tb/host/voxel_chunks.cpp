// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/host/voxel_chunks.h"

#include <algorithm>
#include <cstdint>
#include <deque>

namespace racebeam {

namespace {

constexpr std::size_t MostInFrame = 10;

std::int64_t area(const voxel_rectangle& r) {
  return std::int64_t{r.x_high - r.x_low} * (r.y_high - r.y_low);
}

/// The parts of it that have columns.
std::vector<voxel_rectangle> quarters(const voxel_rectangle& r) {
  const int x = (r.x_low + r.x_high) / 2, y = (r.y_low + r.y_high) / 2;
  std::vector<voxel_rectangle> parts = {{r.x_low, r.y_low, x, y},
                                        {x, r.y_low, r.x_high, y},
                                        {r.x_low, y, x, r.y_high},
                                        {x, y, r.x_high, r.y_high}};
  parts.erase(std::remove_if(parts.begin(), parts.end(),
                             [](const voxel_rectangle& part) { return area(part) == 0; }),
              parts.end());
  return parts;
}

}  // namespace

std::vector<std::vector<voxel_rectangle>> voxel_chunks(std::vector<voxel_rectangle> rectangles,
                                                       int build_chunk) {
  std::deque<voxel_rectangle> queue(rectangles.begin(), rectangles.end());
  std::vector<std::vector<voxel_rectangle>> frames;
  std::int64_t left = 0;  // columns that the last frame may still have
  while (!queue.empty()) {
    const voxel_rectangle next = queue.front();
    queue.pop_front();
    if (area(next) > build_chunk && area(next) > 1) {
      const auto parts = quarters(next);
      queue.insert(queue.begin(), parts.begin(), parts.end());
      continue;
    }
    if (frames.empty() || frames.back().size() == MostInFrame || area(next) > left) {
      frames.emplace_back();
      left = build_chunk;
    }
    frames.back().push_back(next);
    left -= area(next);
  }
  return frames;
}

}  // namespace racebeam
