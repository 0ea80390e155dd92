// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/picture/rgb_image.h"

#include <cmath>
#include <stdexcept>

#include "tb/picture/pixel_font.h"

namespace racebeam {

Rgb mix(Rgb a, Rgb b, double share) {
  const auto one = [share](int from, int to) {
    return static_cast<std::uint8_t>(std::lround(from + (to - from) * share));
  };
  return {one(a.r, b.r), one(a.g, b.g), one(a.b, b.b)};
}

RgbImage::RgbImage(int width, int height, Rgb paper)
    : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * height, paper) {
  static_assert(sizeof(Rgb) == 3);
}

RgbImage::RgbImage(const std::vector<std::uint8_t>& colours, int columns, int rows, int width,
                   int height)
    : RgbImage(width, height) {
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x)
      pixels_[static_cast<std::size_t>(y) * width + x] = rgb_of(colours[y * columns + x]);
}

RgbImage::RgbImage(const PackedPicture& picture) : RgbImage(picture.width, picture.height) {
  if (!picture.whole())
    throw std::invalid_argument("picture: the number of colours is not width * height");
  for (std::size_t n = 0; n < pixels_.size(); ++n)
    pixels_[n] = rgb_of(picture.colour(n), picture.bits);
}

RgbImage RgbImage::top(int width, int height) const {
  RgbImage part(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) part.dot(x, y, at(x, y));
  return part;
}

void RgbImage::fill(int left, int top, int width, int height, Rgb colour) {
  for (int y = top; y < top + height; ++y)
    for (int x = left; x < left + width; ++x) dot(x, y, colour);
}

void RgbImage::tint(int left, int top, int width, int height, Rgb colour, double share) {
  for (int y = top; y < top + height; ++y)
    for (int x = left; x < left + width; ++x)
      if (x >= 0 && x < width_ && y >= 0 && y < height_) dot(x, y, mix(at(x, y), colour, share));
}

void RgbImage::text(int left, int top, std::string_view words, Rgb ink, int scale) {
  int x = left, y = top;
  for (const char c : words) {
    if (c == '\n') {
      x = left;
      y += GlyphHeight * scale;
      continue;
    }
    const std::uint8_t* rows = glyph(c);
    for (int row = 0; row < GlyphHeight; ++row)
      for (int column = 0; column < GlyphWidth; ++column)
        if (rows[row] >> (GlyphWidth - 1 - column) & 1)
          fill(x + column * scale, y + row * scale, scale, scale, ink);
    x += GlyphWidth * scale;
  }
}

}  // namespace racebeam
