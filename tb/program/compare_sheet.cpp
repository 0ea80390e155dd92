// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/compare_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <stdexcept>

namespace racebeam {

namespace {

constexpr int Shrink = 2, Width = 320, Height = 240, Gap = 8, Line = 18, Columns = 4;
constexpr Rgb Paper{24, 24, 28}, Ink{225, 225, 225}, Dim{150, 150, 150};

Rgb mean(const RgbImage& from, int left, int top) {
  std::array<int, 3> sum{};
  for (int y = 0; y < Shrink; ++y)
    for (int x = 0; x < Shrink; ++x) {
      const Rgb one = from.at(left + x, top + y);
      sum[0] += one.r;
      sum[1] += one.g;
      sum[2] += one.b;
    }
  const auto part = [](int all) { return static_cast<std::uint8_t>(all / (Shrink * Shrink)); };
  return {part(sum[0]), part(sum[1]), part(sum[2])};
}

/// Shrunk; larger pictures lose their right and lower parts.
void paste(RgbImage& sheet, const RgbImage& from, int left, int top) {
  const int width = std::min(from.width() / Shrink, Width);
  const int height = std::min(from.height() / Shrink, Height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      sheet.dot(left + x, top + y, mean(from, Shrink * x, Shrink * y));
}

RgbImage map_image(const HitMap& map) {
  VgaFrame frame;
  show_hits(frame, map);
  return RgbImage(frame);
}

void draw_row(RgbImage& sheet, const std::string& group, const ComparedCell& cell, int top) {
  sheet.text(Gap, top + 2,
             fmt::format("{} by {}: {:.2f} clocks a pixel", group, cell.engine,
                         cell.metrics.front().value_or(0)),
             Ink);
  const auto left = [](int column) { return Gap + column * (Width + Gap); };
  paste(sheet, RgbImage(cell.picture), left(0), top + Line);
  if (cell.ideal.width > 0) paste(sheet, RgbImage(cell.ideal), left(1), top + Line);
  paste(sheet, map_image(cell.hits), left(2), top + Line);
  paste(sheet, map_image(cell.ideal_hits), left(3), top + Line);
}

}  // namespace

RgbImage difference_picture(const VgaFrame& picture, const VgaFrame& ideal) {
  if (picture.width != ideal.width || picture.height != ideal.height)
    throw std::invalid_argument("pictures of different sizes");
  RgbImage image(picture);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto n = static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                     static_cast<std::size_t>(x);
      const Rgb is = image.at(x, y), wanted = rgb_of(ideal.colour(n), ideal.bits);
      const int off = std::max(
          {std::abs(is.r - wanted.r), std::abs(is.g - wanted.g), std::abs(is.b - wanted.b)});
      const auto dimmed = [](int level) { return static_cast<std::uint8_t>(level / 4); };
      image.dot(x, y,
                off ? Rgb{static_cast<std::uint8_t>(std::min(255, 95 + 4 * off)),
                          static_cast<std::uint8_t>(std::min(255, 4 * off)), 0}
                    : Rgb{dimmed(is.r), dimmed(is.g), dimmed(is.b)});
    }
  return image;
}

RgbImage compare_sheet(const std::vector<ComparedGroup>& groups) {
  int rows = 0;
  for (const ComparedGroup& group : groups)
    for (const ComparedEngine& column : group.engines) rows += column.cell.has_value();
  const int pitch = Line + Height + Gap;
  RgbImage sheet(Gap + Columns * (Width + Gap), Line + Gap + rows * pitch, Paper);
  constexpr const char* heads[Columns] = {"picture", "golden", "first hits", "golden's first hits"};
  for (int n = 0; n < Columns; ++n) sheet.text(Gap + n * (Width + Gap), 4, heads[n], Dim);
  int top = Line + Gap;
  for (const ComparedGroup& group : groups)
    for (const ComparedEngine& column : group.engines) {
      if (!column.cell) continue;
      draw_row(sheet, group.name, *column.cell, top);
      top += pitch;
    }
  return sheet;
}

}  // namespace racebeam
