// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/picture/png_file.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <map>
#include <new>
#include <optional>
#include <stdexcept>
#include <utility>

#include "tb/base/output_file.h"

namespace racebeam {
namespace {

constexpr int MaxPalette = 256;
using Palette = std::vector<Rgb>;

// The lowest of zlib's levels that makes no frame of the demo larger than its RGB file would be.
constexpr int PaletteEffort = 5;

// libpng lets this leave by an exception.
[[noreturn]] void fail(png_structp, png_const_charp what) {
  throw std::runtime_error(std::string("libpng cannot make a PNG: ") + what);
}

void keep(png_structp png, png_bytep bytes, png_size_t count) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(bytes), count);
}

struct Writer {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  Writer() = default;
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
};

/// `pixels` are indices if there is a palette, else three bytes each.
std::string png_of(const std::uint8_t* pixels, int width, int height, const Palette& palette) {
  std::string bytes;
  const Writer writer;
  const auto [png, info] = std::pair(writer.png, writer.info);
  if (!info) throw std::bad_alloc();
  png_set_write_fn(png, &bytes, keep, nullptr);
  const int colours = static_cast<int>(palette.size());
  const int bits = palette.empty() || colours > 16 ? 8 : colours > 4 ? 4 : colours > 2 ? 2 : 1;
  png_set_IHDR(png, info, width, height, bits,
               palette.empty() ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!palette.empty()) {
    std::array<png_color, MaxPalette> entries{};
    std::transform(palette.begin(), palette.end(), entries.begin(), [](Rgb colour) {
      return png_color{colour.r, colour.g, colour.b};
    });
    png_set_PLTE(png, info, entries.data(), colours);
    png_set_compression_level(png, PaletteEffort);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
  }
  png_write_info(png, info);
  png_set_packing(png);
  const std::size_t stride = static_cast<std::size_t>(width) * (palette.empty() ? 3 : 1);
  for (int y = 0; y < height; ++y) png_write_row(png, pixels + y * stride);
  png_write_end(png, nullptr);
  return bytes;
}

/// The colours of a picture from dark to light, so that the same pixels make the same file, and the
/// index of each pixel's; nothing if there are too many.
struct Indexed {
  Palette palette;
  std::vector<std::uint8_t> pixels;
};
std::optional<Indexed> indexed(const RgbImage& picture) {
  const std::size_t count = static_cast<std::size_t>(picture.width()) * picture.height();
  const std::uint8_t* const bytes = picture.bytes();
  const auto colour_of = [](const std::uint8_t* p) { return p[0] << 16 | p[1] << 8 | p[2]; };
  std::map<int, std::uint8_t> index;
  int last = -1;  // most pixels are as the one before
  for (const std::uint8_t* p = bytes; p != bytes + 3 * count; p += 3) {
    if (colour_of(p) == last) continue;
    last = colour_of(p);
    index[last] = 0;
    if (index.size() > MaxPalette) return {};
  }
  Indexed result;
  for (auto& [colour, number] : index) {
    number = static_cast<std::uint8_t>(result.palette.size());
    result.palette.push_back({static_cast<std::uint8_t>(colour >> 16),
                              static_cast<std::uint8_t>(colour >> 8),
                              static_cast<std::uint8_t>(colour)});
  }
  result.pixels.reserve(count);
  last = -1;
  for (const std::uint8_t* p = bytes; p != bytes + 3 * count; p += 3) {
    const bool same = colour_of(p) == last;
    last = colour_of(p);
    result.pixels.push_back(same ? result.pixels.back() : index.at(last));
  }
  return result;
}

}  // namespace

std::string png_bytes(const std::vector<std::uint8_t>& colours, int width, int height) {
  if (width < 1 || height < 1 || colours.size() != static_cast<std::size_t>(width) * height)
    throw std::invalid_argument("picture: the number of colours is not width * height");
  // Only the colours that there are: few of them take few bits a pixel.
  std::array<bool, 64> used{};
  for (const std::uint8_t colour : colours) used[colour & 63] = true;
  Palette palette;
  std::array<std::uint8_t, 64> index{};
  for (int colour = 0; colour < 64; ++colour)
    if (used[colour]) {
      index[colour] = static_cast<std::uint8_t>(palette.size());
      palette.push_back(rgb_of(colour));
    }
  std::vector<std::uint8_t> pixels(colours.size());
  std::transform(colours.begin(), colours.end(), pixels.begin(),
                 [&](std::uint8_t colour) { return index[colour & 63]; });
  return png_of(pixels.data(), width, height, palette);
}

std::string png_bytes(const RgbImage& picture) {
  const auto few = indexed(picture);
  return few ? png_of(few->pixels.data(), picture.width(), picture.height(), few->palette)
             : png_of(picture.bytes(), picture.width(), picture.height(), {});
}

void write_png(const std::string& path, const std::vector<std::uint8_t>& colours, int width,
               int height) {
  write_text(path, png_bytes(colours, width, height));
}

void write_png(const std::string& path, const RgbImage& picture) {
  write_text(path, png_bytes(picture));
}

}  // namespace racebeam
