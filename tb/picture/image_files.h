// Pictures of 6-bit colours as files: PNG, contact sheet, animated GIF.
//
// Nothing else in the program uses OpenImageIO. Every file appears whole or not at all; errors are
// OutputError. A 2-bit channel value v becomes v * 85 of 255.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/base/output_file.h"
#include "tb/picture/gif_writer.h"
#include "tb/picture/rgb_image.h"

namespace racebeam {

/// width * height colours, row by row, r * 16 + g * 4 + b, as the bytes of an 8-bit RGB PNG file.
/// Throws std::invalid_argument if the sizes disagree.
std::string png_bytes(const std::vector<std::uint8_t>& colours, int width, int height);
/// A picture as the bytes of an 8-bit RGB PNG file.
std::string png_bytes(const RgbImage& picture);

/// Writes png_bytes() of the same. Throws OutputError, and as that does.
void write_png(const std::string& path, const std::vector<std::uint8_t>& colours, int width,
               int height);

void write_png(const std::string& path, const RgbImage& picture);

/// One picture of a contact sheet.
struct SheetFrame {
  std::vector<std::uint8_t> colours;  ///< as for write_png
  std::string caption;                ///< one short line
};

/// Writes all frames, each width x height pixels, in rows of `columns` as one PNG, shrunk by
/// `downscale` in both axes (means of pixels), with their captions below if a font is found.
/// Throws OutputError, and std::invalid_argument if the sizes disagree or there are no frames.
void write_contact_sheet(const std::string& path, const std::vector<SheetFrame>& frames, int width,
                         int height, int columns, int downscale = 2);

}  // namespace racebeam
