// Formats of picture files by name: PNG by png_file.h, the others by OpenImageIO.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/picture/rgb_image.h"

namespace racebeam {

struct PictureFormat {
  const char* name;         ///< as files end, without the dot
  const char* writer;       ///< OpenImageIO's name of it; nullptr: png_file.h
  const char* compression;  ///< OpenImageIO's word
  const char* note;         ///< what it keeps, for the user
  bool light = false;       ///< holds linear light as 16-bit floats, not bytes of sRGB
};

/// PNG is the first.
const std::vector<PictureFormat>& picture_formats();

/// Throws UsageError with all names.
const PictureFormat& picture_format(const std::string& name);
/// By the extension of a file's name, in any case; nullptr if it is no picture's.
const PictureFormat* format_of_file(const std::string& path);

/// A picture file's bytes. Throws MissingTool if OpenImageIO is not there or cannot write this.
std::string picture_bytes(const PictureFormat& format, const RgbImage& picture);
/// The same of any depth. Throws std::invalid_argument if it is not whole.
std::string picture_bytes(const PictureFormat& format, const PackedPicture& picture);
/// width * height colours of the chip.
std::string picture_bytes(const PictureFormat& format, const std::vector<std::uint8_t>& colours,
                          int width, int height);

}  // namespace racebeam
