// ViewRecorder: screenshots and GIFs of what a viewer shows.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tb/picture/gif_writer.h"
#include "tb/picture/rgb_image.h"

namespace racebeam {

class ViewRecorder {
 public:
  explicit ViewRecorder(std::string folder) : folder_(std::move(folder)) {}

  /// Writes view_0060.png, or view_0060_2.png if that is there. Returns its name. Throws
  /// OutputError.
  std::string screenshot(const RgbImage& picture, int frame) const;

  /// Writes view_0060.csv, or another as above. Returns its name. Throws OutputError.
  std::string inputs(const std::string& text, int frame) const;

  bool recording() const { return gif_ != nullptr; }
  /// Begins view_0060.gif, which has the chip's own pictures, without overlays, and plays at the
  /// speed of the show; `bits` a channel. Throws OutputError.
  void start(int frame, int columns, int rows, double frames_per_second, int bits = 2);
  const std::string& gif_name() const { return gif_name_; }
  /// A whole frame, if it is recording, so many frames of the show after the one before. Throws
  /// OutputError.
  void add(const std::vector<std::uint8_t>& colours, int after);
  /// Ends the GIF. Returns what was written. Throws OutputError.
  std::string stop();

 private:
  std::string free_name(int frame, const std::string& extension) const;

  std::string folder_, gif_name_;
  std::unique_ptr<GifWriter> gif_;
  bool empty_ = true;
};

}  // namespace racebeam
