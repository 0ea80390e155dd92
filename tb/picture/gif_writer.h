// GifWriter: an animated GIF that keeps the 64 colours of two bits a channel exactly.
//
// OpenImageIO's own GIF writer makes a palette of its own for each frame and dithers into it, which
// changes pixels even in frames of two to four colours; it also has no way to turn that off, and
// does not notice a full disk. giflib writes what it is given: one fixed palette of 64 colours.
// Deeper pictures get the nearest of 252: six levels of red and blue, seven of green.
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

#include "tb/base/output_file.h"

namespace racebeam {

class GifWriter {
 public:
  /// Frames of `width` x `height` pixels, shown at `frames_per_second`, for ever. GIF counts in
  /// 1/100 s, and viewers slow down pictures shorter than two of them: each frame begins within
  /// 1/100 s of its time, and of more than 50 a second some are left out, one of six at 60. Of each
  /// `downscale` x `downscale` pixels the top left one is kept. `bits`: of the frames' channels.
  /// Throws OutputError and std::invalid_argument.
  GifWriter(const std::string& path, int width, int height, double frames_per_second,
            int downscale = 1, int bits = 2);

  /// Adds a frame of width * height colours, as PackedPicture has them, so many frames after the
  /// one before; the first begins the GIF. Throws OutputError.
  void add(const std::vector<std::uint8_t>& colours, int after = 1);

  /// Ends the file a frame after the last one and gives it its name; without it nothing is left.
  /// Throws OutputError.
  void close();

  /// In the file, when it is closed.
  int pictures() const { return pictures_; }
  double seconds() const { return begin_ / 100.0; }

 private:
  static int write_bytes(GifFileType* gif, const GifByteType* data, int size);
  /// Throws what write_bytes met, or giflib's own word.
  void check(bool good);
  /// Writes the picture that waits, shown up to `end`, at least for the shortest delay.
  void write(long end);
  /// When a frame begins, in 1/100 s.
  long due(long frame) const;

  OutputFile file_;
  std::exception_ptr failure_;
  struct Closer {
    void operator()(GifFileType* gif) const { EGifCloseFile(gif, nullptr); }
  };
  std::unique_ptr<GifFileType, Closer> gif_;
  const int width_, height_, downscale_, bits_;  // of the frames given
  const int columns_, rows_;                     // of the file
  const double rate_;                            // frames a second
  long frame_ = 0;                               // that waits
  long begin_ = 0;                               // of its picture, 1/100 s
  bool waiting_ = false;
  int pictures_ = 0;                        // written
  std::vector<std::uint8_t> shown_, next_;  // columns x rows: written last, waiting
};

}  // namespace racebeam
