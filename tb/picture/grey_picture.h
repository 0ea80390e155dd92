// Grey pictures of files, as numbers: 8 or 16 bits a pixel, by OpenImageIO.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace racebeam {

struct GreyPicture {
  int width = 0, height = 0;
  int bits = 8;                       ///< of a pixel: 8, or 16
  std::vector<std::uint16_t> pixels;  ///< row by row, from the top

  int at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// Reads a picture of one channel, or of several that are equal in each pixel; what it has beside
/// colours does not count. Returns what is wrong, or nothing. Throws MissingTool if OpenImageIO is
/// not there.
std::string read_grey_picture(const std::string& path, GreyPicture& to);

}  // namespace racebeam
