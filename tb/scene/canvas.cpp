// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/canvas.h"

#include <algorithm>
#include <cstdlib>

namespace racebeam {

Canvas::Canvas(int width, int height, Colour paper)
    : width_(width), height_(height), colours_(static_cast<std::size_t>(width) * height, paper) {}

void Canvas::dot(int x, int y, Colour colour) {
  if (x >= 0 && x < width_ && y >= 0 && y < height_) colours_[y * width_ + x] = colour;
}

void Canvas::fill(int left, int top, int right, int bottom, Colour colour) {
  for (int y = std::max(top, 0); y <= std::min(bottom, height_ - 1); ++y)
    for (int x = std::max(left, 0); x <= std::min(right, width_ - 1); ++x) dot(x, y, colour);
}

void Canvas::frame(int left, int top, int right, int bottom, Colour colour) {
  fill(left, top, right, top, colour);
  fill(left, bottom, right, bottom, colour);
  fill(left, top, left, bottom, colour);
  fill(right, top, right, bottom, colour);
}

void Canvas::line(int x0, int y0, int x1, int y1, Colour colour) {
  const int steps = std::max({std::abs(x1 - x0), std::abs(y1 - y0), 1});
  for (int i = 0; i <= steps; ++i)
    dot(x0 + (x1 - x0) * i / steps, y0 + (y1 - y0) * i / steps, colour);
}

}  // namespace racebeam
