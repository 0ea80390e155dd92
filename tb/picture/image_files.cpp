// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/picture/image_files.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <stdexcept>

namespace racebeam {
namespace {

constexpr int Channels = 3;
constexpr int Gap = 8;             // pixels around a thumbnail
constexpr int CaptionHeight = 22;  // pixels
constexpr int FontSize = 14;       // pixels
constexpr std::uint8_t Paper = 32, Ink = 224;

std::uint8_t channel(int colour, int index) {
  return static_cast<std::uint8_t>((colour >> (4 - 2 * index) & 3) * 85);
}

void check_size(const std::vector<std::uint8_t>& colours, int width, int height) {
  if (width < 1 || height < 1 || colours.size() != static_cast<std::size_t>(width) * height)
    throw std::invalid_argument("picture: the number of colours is not width * height");
}

/// `rgb` holds 8-bit values, row by row.
std::string png_of(const std::uint8_t* rgb, int width, int height) {
  OIIO::Filesystem::IOVecOutput bytes;
  const auto out = OIIO::ImageOutput::create("png");
  if (!out) throw std::runtime_error("OpenImageIO has no PNG: " + OIIO::geterror());
  OIIO::ImageSpec spec(width, height, Channels, OIIO::TypeDesc::UINT8);
  OIIO::Filesystem::IOProxy* const target = &bytes;
  spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &target);
  // Each step may also report success and leave an error behind.
  if (!out->open("memory.png", spec) || !out->write_image(OIIO::TypeDesc::UINT8, rgb) ||
      !out->close() || out->has_error())
    throw std::runtime_error("OpenImageIO cannot make a PNG: " + out->geterror());
  return {bytes.buffer().begin(), bytes.buffer().end()};
}

/// Means of blocks of pixels, put at (left, top) of the sheet.
void put_thumbnail(OIIO::ImageBuf& sheet, const SheetFrame& frame, int width, int height,
                   int downscale, int left, int top) {
  auto* const pixels = static_cast<std::uint8_t*>(sheet.localpixels());
  const int area = downscale * downscale;
  for (int y = 0; y < height / downscale; ++y)
    for (int x = 0; x < width / downscale; ++x) {
      int sum[Channels] = {};
      for (int i = 0; i < area; ++i) {
        const int from = (y * downscale + i / downscale) * width + x * downscale + i % downscale;
        for (int c = 0; c < Channels; ++c) sum[c] += channel(frame.colours[from], c);
      }
      const std::size_t to = static_cast<std::size_t>(top + y) * sheet.spec().width + left + x;
      for (int c = 0; c < Channels; ++c)
        pixels[to * Channels + c] = static_cast<std::uint8_t>((sum[c] + area / 2) / area);
    }
}

/// Without a font there is no caption.
void put_caption(OIIO::ImageBuf& sheet, const std::string& caption, int left, int baseline,
                 int width) {
  const float ink = Ink / 255.0F;
  const float colour[Channels] = {ink, ink, ink};
  const OIIO::ROI roi(left, left + width, 0, sheet.spec().height, 0, 1, 0, Channels);
  using OIIO::ImageBufAlgo::TextAlignX;
  using OIIO::ImageBufAlgo::TextAlignY;
  for (const char* font : {"", "DejaVuSans", "LiberationSans-Regular"}) {
    if (OIIO::ImageBufAlgo::render_text(sheet, left, baseline, caption, FontSize, font, colour,
                                        TextAlignX::Left, TextAlignY::Baseline, 0, roi))
      return;
    (void)sheet.geterror();
  }
}

}  // namespace

std::string png_bytes(const std::vector<std::uint8_t>& colours, int width, int height) {
  check_size(colours, width, height);
  std::vector<std::uint8_t> rgb;
  rgb.reserve(colours.size() * Channels);
  for (const std::uint8_t colour : colours)
    for (int c = 0; c < Channels; ++c) rgb.push_back(channel(colour, c));
  return png_of(rgb.data(), width, height);
}

std::string png_bytes(const RgbImage& picture) {
  return png_of(picture.bytes(), picture.width(), picture.height());
}

void write_png(const std::string& path, const std::vector<std::uint8_t>& colours, int width,
               int height) {
  write_text(path, png_bytes(colours, width, height));
}

void write_png(const std::string& path, const RgbImage& picture) {
  write_text(path, png_bytes(picture));
}

void write_contact_sheet(const std::string& path, const std::vector<SheetFrame>& frames, int width,
                         int height, int columns, int downscale) {
  if (frames.empty()) throw std::invalid_argument("contact sheet: no frames");
  if (columns < 1) throw std::invalid_argument("contact sheet: bad columns");
  for (const SheetFrame& frame : frames) check_size(frame.colours, width, height);
  if (downscale < 1 || downscale > std::min(width, height))
    throw std::invalid_argument("contact sheet: bad downscale");
  const int across = std::min(columns, static_cast<int>(frames.size()));
  const int down = (static_cast<int>(frames.size()) + across - 1) / across;
  const int cell_width = width / downscale + Gap;
  const int cell_height = height / downscale + CaptionHeight + Gap;
  OIIO::ImageBuf sheet(OIIO::ImageSpec(across * cell_width + Gap, down * cell_height + Gap,
                                       Channels, OIIO::TypeDesc::UINT8));
  const float paper = Paper / 255.0F;
  OIIO::ImageBufAlgo::fill(sheet, {paper, paper, paper});
  for (int i = 0; i < static_cast<int>(frames.size()); ++i) {
    const int left = Gap + i % across * cell_width, top = Gap + i / across * cell_height;
    put_thumbnail(sheet, frames[i], width, height, downscale, left, top);
    put_caption(sheet, frames[i].caption, left,
                top + cell_height - Gap - (CaptionHeight - FontSize), cell_width - Gap);
  }
  write_text(path, png_of(static_cast<const std::uint8_t*>(sheet.localpixels()), sheet.spec().width,
                          sheet.spec().height));
}

}  // namespace racebeam
