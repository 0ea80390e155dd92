// ImageLibrary: what OpenImageIO does for the program, opened when it is first asked for.
//
// OpenImageIO brings 260 shared libraries and a thread of its own. It is behind
// libracebeam_images.so, a library of the program's own.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

namespace racebeam {

struct GreyPicture;
struct PictureFormat;

struct ImageLibrary {
  const char* version;  ///< of OpenImageIO

  /// Writes a line into a picture of width * height pixels, three bytes each: from `left` to
  /// `right`, on a baseline. Nothing if there is no font.
  void (*put_text)(std::uint8_t* rgb, int width, int height, const std::string& words, int left,
                   int right, int baseline);

  /// Puts a picture of width * height pixels, three bytes each, into the bytes of a file. Returns
  /// what is wrong, or nothing.
  std::string (*encode)(const PictureFormat& format, const std::uint8_t* rgb, int width, int height,
                        std::string& bytes);

  /// Reads a grey picture from a file: read_grey_picture().
  std::string (*read_grey)(const std::string& path, GreyPicture& to);
};

/// Opens it at the first call. Throws MissingTool if it or OpenImageIO is not there.
const ImageLibrary& image_library();

}  // namespace racebeam
