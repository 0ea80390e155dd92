// Pictures as the bytes of a PNG file.
//
// Up to 256 colours become a palette, which takes a fifth of the time of an RGB file and less
// space; a frame of the chip has at most 64.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/picture/rgb_image.h"

namespace racebeam {

/// width * height colours, row by row, r * 16 + g * 4 + b. Throws std::invalid_argument if the
/// sizes disagree.
std::string png_bytes(const std::vector<std::uint8_t>& colours, int width, int height);
std::string png_bytes(const RgbImage& picture);

/// Writes png_bytes() of the same. Throws OutputError, and as that does.
void write_png(const std::string& path, const std::vector<std::uint8_t>& colours, int width,
               int height);
void write_png(const std::string& path, const RgbImage& picture);

}  // namespace racebeam
