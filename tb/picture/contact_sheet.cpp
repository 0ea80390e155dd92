// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/picture/contact_sheet.h"

#include <algorithm>
#include <stdexcept>

#include "tb/base/output_file.h"
#include "tb/picture/image_library.h"
#include "tb/picture/picture_format.h"

namespace racebeam {
namespace {

constexpr int Gap = 8;             // pixels around a thumbnail
constexpr int CaptionHeight = 22;  // pixels
constexpr int Baseline = 14;       // pixels below a thumbnail
constexpr Rgb Paper = {32, 32, 32};

/// Means of blocks of pixels, put at (left, top) of the sheet.
void put_thumbnail(RgbImage& sheet, const PackedPicture& picture, int downscale, int left,
                   int top) {
  const int area = downscale * downscale;
  const auto mean = [&](int sum) { return static_cast<std::uint8_t>((sum + area / 2) / area); };
  for (int y = 0; y < picture.height / downscale; ++y)
    for (int x = 0; x < picture.width / downscale; ++x) {
      int r = 0, g = 0, b = 0;
      for (int i = 0; i < area; ++i) {
        const int from =
            (y * downscale + i / downscale) * picture.width + x * downscale + i % downscale;
        const Rgb pixel = rgb_of(picture.colour(static_cast<std::size_t>(from)), picture.bits);
        r += pixel.r;
        g += pixel.g;
        b += pixel.b;
      }
      sheet.dot(left + x, top + y, {mean(r), mean(g), mean(b)});
    }
}

}  // namespace

void write_contact_sheet(const std::string& path, const std::vector<SheetFrame>& frames, int width,
                         int height, int columns, int downscale) {
  if (frames.empty()) throw std::invalid_argument("contact sheet: no frames");
  if (columns < 1) throw std::invalid_argument("contact sheet: bad columns");
  const auto picture_of = [=](const SheetFrame& frame) {
    return PackedPicture{width, height, frame.bits, frame.colours};
  };
  for (const SheetFrame& frame : frames)
    if (!picture_of(frame).whole())
      throw std::invalid_argument("contact sheet: the number of colours is not width * height");
  if (downscale < 1 || downscale > std::min(width, height))
    throw std::invalid_argument("contact sheet: bad downscale");
  const int count = static_cast<int>(frames.size());
  const int across = std::min(columns, count), down = (count + across - 1) / across;
  const int cell_width = width / downscale + Gap;
  const int cell_height = height / downscale + CaptionHeight + Gap;
  RgbImage sheet(across * cell_width + Gap, down * cell_height + Gap, Paper);
  const ImageLibrary& images = image_library();
  for (int i = 0; i < count; ++i) {
    const int left = Gap + i % across * cell_width, top = Gap + i / across * cell_height;
    put_thumbnail(sheet, picture_of(frames[i]), downscale, left, top);
    images.put_text(sheet.bytes(), sheet.width(), sheet.height(), frames[i].caption, left,
                    left + cell_width - Gap, top + height / downscale + Baseline);
  }
  const PictureFormat* const format = format_of_file(path);
  write_text(path, picture_bytes(format ? *format : picture_formats().front(), sheet));
}

}  // namespace racebeam
