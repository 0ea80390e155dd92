// PackedPicture: what an engine draws, at its own size and depth of colour.
//
// A colour is one whole number, red above green above blue, each of `bits`: 0 is black, all bits
// set are full light. It takes as few bytes as hold it, of 1, 2 and 4, the lowest first: a picture
// of 2 bits has one byte a pixel, r * 16 + g * 4 + b.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace racebeam {

struct PackedPicture {
  int width = 0, height = 0;
  int bits = 2;                       ///< of each of the three channels, 1..10
  std::vector<std::uint8_t> colours;  ///< row by row

  static constexpr int bytes_of(int bits) { return bits <= 2 ? 1 : bits <= 5 ? 2 : 4; }
  int colour_bytes() const { return bytes_of(bits); }
  std::size_t pixels() const { return static_cast<std::size_t>(width) * height; }
  /// Whether there are as many colours as pixels.
  bool whole() const {
    return width > 0 && height > 0 && colours.size() == pixels() * colour_bytes();
  }

  /// Of a pixel, counted row by row.
  std::uint32_t colour(std::size_t pixel) const {
    std::uint32_t colour = 0;
    for (int n = colour_bytes(); n-- > 0;)
      colour = colour << 8 | colours[pixel * static_cast<std::size_t>(colour_bytes()) + n];
    return colour;
  }
  /// The next pixel.
  void push(std::uint32_t colour) {
    for (int n = 0; n < colour_bytes(); ++n, colour >>= 8)
      colours.push_back(static_cast<std::uint8_t>(colour));
  }
};

}  // namespace racebeam
