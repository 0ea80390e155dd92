// RgbImage: a picture of 24-bit colours to draw and write on.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "tb/base/packed_picture.h"

namespace racebeam {

struct Rgb {
  std::uint8_t r, g, b;
  bool operator==(const Rgb& o) const { return r == o.r && g == o.g && b == o.b; }
  bool operator!=(const Rgb& o) const { return !(*this == o); }
};

/// A colour of the chip, r * 16 + g * 4 + b, as a monitor shows it: 85 a step.
constexpr Rgb rgb_of(int colour) {
  return {static_cast<std::uint8_t>((colour >> 4 & 3) * 85),
          static_cast<std::uint8_t>((colour >> 2 & 3) * 85),
          static_cast<std::uint8_t>((colour & 3) * 85)};
}

/// A colour of `bits` a channel, red above green above blue: to the nearest of 255 steps.
constexpr Rgb rgb_of(std::uint32_t colour, int bits) {
  const std::uint32_t most = (1u << bits) - 1;
  const auto channel = [=](int above) {
    return static_cast<std::uint8_t>(((colour >> above & most) * 255 + most / 2) / most);
  };
  return {channel(2 * bits), channel(bits), channel(0)};
}

/// `share` of `b`, 0..1, the rest of `a`.
Rgb mix(Rgb a, Rgb b, double share);

class RgbImage {
 public:
  RgbImage(int width, int height, Rgb paper = {0, 0, 0});
  /// A picture of columns x rows of the chip's colours, at the top left of a larger black one.
  RgbImage(const std::vector<std::uint8_t>& colours, int columns, int rows, int width, int height);
  /// A picture of any depth. Throws std::invalid_argument if it is not whole.
  explicit RgbImage(const PackedPicture& picture);

  /// Its top left part.
  RgbImage top(int width, int height) const;

  int width() const { return width_; }
  int height() const { return height_; }
  /// Row by row, three bytes a pixel.
  const std::uint8_t* bytes() const { return &pixels_.front().r; }
  std::uint8_t* bytes() { return &pixels_.front().r; }
  Rgb at(int x, int y) const { return pixels_[static_cast<std::size_t>(y) * width_ + x]; }

  /// All of these keep within the picture.
  void dot(int x, int y, Rgb colour) {
    if (x >= 0 && x < width_ && y >= 0 && y < height_)
      pixels_[static_cast<std::size_t>(y) * width_ + x] = colour;
  }
  void fill(int left, int top, int width, int height, Rgb colour);
  /// Mixes `share` of `colour` into what is there.
  void tint(int left, int top, int width, int height, Rgb colour, double share);
  /// Letters 6 x 13 times `scale`; a line feed starts a new line below. The place is the top left.
  void text(int left, int top, std::string_view words, Rgb ink, int scale = 1);

 private:
  int width_, height_;
  std::vector<Rgb> pixels_;
};

}  // namespace racebeam
