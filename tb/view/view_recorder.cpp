// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/view_recorder.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "tb/base/counted.h"
#include "tb/base/output_file.h"
#include "tb/picture/png_file.h"

namespace racebeam {

namespace fs = std::filesystem;

std::string ViewRecorder::free_name(int frame, const std::string& extension) const {
  std::error_code ignored;
  fs::create_directories(folder_, ignored);
  for (int copy = 1;; ++copy) {
    const std::string name =
        copy == 1 ? fmt::format("view_{:04}", frame) : fmt::format("view_{:04}_{}", frame, copy);
    const fs::path path = fs::path(folder_) / (name + extension);
    if (!fs::exists(path, ignored)) return path.lexically_normal().string();
  }
}

std::string ViewRecorder::screenshot(const RgbImage& picture, int frame) const {
  const std::string name = free_name(frame, ".png");
  write_png(name, picture);
  return name;
}

std::string ViewRecorder::inputs(const std::string& text, int frame) const {
  const std::string name = free_name(frame, ".csv");
  write_text(name, text);
  return name;
}

void ViewRecorder::start(int frame, int columns, int rows, double frames_per_second, int bits) {
  gif_name_ = free_name(frame, ".gif");
  empty_ = true;
  gif_ = std::make_unique<GifWriter>(gif_name_, columns, rows, frames_per_second, 1, bits);
}

void ViewRecorder::add(const std::vector<std::uint8_t>& colours, int after) {
  if (!gif_) return;
  gif_->add(colours, after);
  empty_ = false;
}

std::string ViewRecorder::stop() {
  const std::unique_ptr<GifWriter> gif = std::move(gif_);
  if (empty_) return "recorded nothing";
  gif->close();
  return fmt::format("wrote {}, {:.2f} s in {}", gif_name_, gif->seconds(),
                     counted(gif->pictures(), "picture"));
}

}  // namespace racebeam
