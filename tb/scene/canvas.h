// Canvas: lines and rectangles of 6-bit colours, for drawings of scenes.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace racebeam {

/// A colour of the chip: r * 16 + g * 4 + b.
using Colour = std::uint8_t;

class Canvas {
 public:
  Canvas(int width, int height, Colour paper);

  int width() const { return width_; }
  int height() const { return height_; }
  /// Row by row, as write_png takes them.
  const std::vector<Colour>& colours() const { return colours_; }
  Colour at(int x, int y) const { return colours_[y * width_ + x]; }

  /// All of these keep within the canvas.
  void dot(int x, int y, Colour colour);
  /// Corners included.
  void fill(int left, int top, int right, int bottom, Colour colour);
  void frame(int left, int top, int right, int bottom, Colour colour);
  void line(int x0, int y0, int x1, int y1, Colour colour);

 private:
  int width_, height_;
  std::vector<Colour> colours_;
};

}  // namespace racebeam
