// GifWriter: an animated GIF that keeps the chip's 64 colours exactly.
//
// OpenImageIO's own GIF writer makes a palette of its own for each frame and dithers into it, which
// changes pixels even in frames of two to four colours; it also has no way to turn that off, and
// does not notice a full disk. giflib writes what it is given: one fixed palette of 64 colours.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gif_lib.h>

#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "tb/output_file.h"

namespace racebeam {

class GifWriter {
 public:
  /// Frames of `width` x `height` pixels, shown at `frames_per_second`, for ever. GIF counts in
  /// 1/100 s and viewers slow down what is faster than 50 per second: the nearest rate up to 50 is
  /// taken. Of each `downscale` x `downscale` pixels the top left one is kept. Throws OutputError
  /// and std::invalid_argument.
  GifWriter(const std::string& path, int width, int height, double frames_per_second,
            int downscale = 1);

  /// Adds a frame of width * height colours, r * 16 + g * 4 + b. Throws OutputError.
  void add(const std::vector<std::uint8_t>& colours);

  /// Ends the file and gives it its name; without it nothing is left. Throws OutputError.
  void close();

  int frames() const { return frames_; }

 private:
  static int write_bytes(GifFileType* gif, const GifByteType* data, int size);
  /// Throws what write_bytes met, or giflib's own word.
  void check(bool good);

  OutputFile file_;
  std::exception_ptr failure_;
  struct Closer {
    void operator()(GifFileType* gif) const { EGifCloseFile(gif, nullptr); }
  };
  std::unique_ptr<GifFileType, Closer> gif_;
  const int width_, height_, downscale_;  // of the frames given
  const int columns_, rows_;              // of the file
  const int delay_;                       // 1/100 s
  int frames_ = 0;
  std::vector<std::uint8_t> shown_, next_;  // columns x rows
};

}  // namespace racebeam
