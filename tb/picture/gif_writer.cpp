// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/picture/gif_writer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tb/picture/rgb_image.h"

namespace racebeam {
namespace {

constexpr int ChipBits = 2;                     // a channel; deeper pictures are brought down
constexpr int Reds = 6, Greens = 7, Blues = 6;  // of a deeper picture
constexpr int LightSteps = 255;

/// The colours of the file, of pictures with `bits` a channel.
std::vector<GifColorType> palette_of(int bits) {
  std::vector<GifColorType> palette;
  if (bits == ChipBits) {
    for (std::uint32_t colour = 0; colour < 1 << 3 * ChipBits; ++colour) {
      const Rgb rgb = rgb_of(colour, ChipBits);
      palette.push_back({rgb.r, rgb.g, rgb.b});
    }
    return palette;
  }
  const auto level = [](int n, int levels) {
    return static_cast<GifByteType>((n * LightSteps + (levels - 1) / 2) / (levels - 1));
  };
  for (int r = 0; r < Reds; ++r)
    for (int g = 0; g < Greens; ++g)
      for (int b = 0; b < Blues; ++b)
        palette.push_back({level(r, Reds), level(g, Greens), level(b, Blues)});
  palette.resize(256);  // GIF wants a power of two
  return palette;
}

/// The nearest of them.
GifByteType index_of(std::uint32_t colour, int bits) {
  if (bits == ChipBits) return static_cast<GifByteType>(colour & ((1 << 3 * ChipBits) - 1));
  const Rgb rgb = rgb_of(colour, bits);
  const auto nearest = [](int light, int levels) {
    return (light * (levels - 1) + LightSteps / 2) / LightSteps;
  };
  return static_cast<GifByteType>((nearest(rgb.r, Reds) * Greens + nearest(rgb.g, Greens)) * Blues +
                                  nearest(rgb.b, Blues));
}

int checked(int value, int max, const char* name) {
  if (value < 1 || value > max) throw std::invalid_argument(std::string("GIF: bad ") + name);
  return value;
}

constexpr long ShortestDelay = 2, LongestDelay = 65535;  // 1/100 s

double checked_rate(double frames_per_second) {
  if (!(frames_per_second > 0)) throw std::invalid_argument("GIF: bad frames per second");
  return frames_per_second;
}

}  // namespace

GifWriter::GifWriter(const std::string& path, int width, int height, double frames_per_second,
                     int downscale, int bits)
    : file_(path),
      width_(checked(width, 65535, "width")),
      height_(checked(height, 65535, "height")),
      downscale_(checked(downscale, std::min(width, height), "downscale")),
      bits_(checked(bits, 10, "depth of colour")),
      columns_(width / downscale),
      rows_(height / downscale),
      rate_(checked_rate(frames_per_second)),
      shown_(static_cast<std::size_t>(columns_) * rows_),
      next_(shown_.size()) {
  const std::vector<GifColorType> palette = palette_of(bits);
  gif_.reset(EGifOpen(this, write_bytes, nullptr));
  if (!gif_) throw OutputError(path, "giflib has no memory");
  EGifSetGifVersion(gif_.get(), true);
  ColorMapObject* map = GifMakeMapObject(static_cast<int>(palette.size()), palette.data());
  const bool begun =
      EGifPutScreenDesc(gif_.get(), columns_, rows_, map->BitsPerPixel, 0, map) == GIF_OK;
  GifFreeMapObject(map);
  check(begun);
  const unsigned char for_ever[3] = {1, 0, 0};
  check(EGifPutExtensionLeader(gif_.get(), APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
        EGifPutExtensionBlock(gif_.get(), 11, "NETSCAPE2.0") == GIF_OK &&
        EGifPutExtensionBlock(gif_.get(), sizeof for_ever, for_ever) == GIF_OK &&
        EGifPutExtensionTrailer(gif_.get()) == GIF_OK);
}

// Called by giflib, a C library: nothing may be thrown through it.
int GifWriter::write_bytes(GifFileType* gif, const GifByteType* data, int size) {
  auto* self = static_cast<GifWriter*>(gif->UserData);
  if (self->failure_) return 0;
  try {
    self->file_.write(data, static_cast<std::size_t>(size));
    return size;
  } catch (...) {
    self->failure_ = std::current_exception();
    return 0;
  }
}

void GifWriter::check(bool good) {
  if (failure_) std::rethrow_exception(failure_);
  if (!good) throw OutputError(file_.path(), GifErrorString(gif_->Error));
}

long GifWriter::due(long frame) const { return std::lround(100.0 * frame / rate_); }

// A picture waits until its end is known. It gives way to one that is due when it would begin.
void GifWriter::add(const std::vector<std::uint8_t>& colours, int after) {
  const std::size_t bytes = PackedPicture::bytes_of(bits_);
  if (colours.size() != static_cast<std::size_t>(width_) * height_ * bytes)
    throw std::invalid_argument("GIF: the frame has another size");
  if (waiting_) frame_ += after;
  if (waiting_ && due(frame_) > begin_) write(due(frame_));
  waiting_ = true;
  for (int y = 0; y < rows_; ++y)
    for (int x = 0; x < columns_; ++x) {
      const std::size_t from = (static_cast<std::size_t>(y) * width_ + x) * downscale_ * bytes;
      std::uint32_t colour = 0;
      for (std::size_t n = bytes; n-- > 0;) colour = colour << 8 | colours[from + n];
      next_[static_cast<std::size_t>(y) * columns_ + x] = index_of(colour, bits_);
    }
}

void GifWriter::write(long end) {
  const long delay = std::clamp(end - begin_, ShortestDelay, LongestDelay);
  begin_ += delay;
  // Only the box that changed is written.
  int left = columns_, top = rows_, right = 0, bottom = 0;
  for (int y = 0; y < rows_; ++y)
    for (int x = 0; x < columns_; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * columns_ + x;
      if (pictures_ > 0 && next_[i] == shown_[i]) continue;
      left = std::min(left, x);
      right = std::max(right, x + 1);
      top = std::min(top, y);
      bottom = y + 1;
    }
  if (right == 0) {  // nothing did: one pixel carries the delay
    left = top = 0;
    right = bottom = 1;
  }
  shown_.swap(next_);

  const GraphicsControlBlock control{DISPOSE_DO_NOT, false, static_cast<int>(delay),
                                     NO_TRANSPARENT_COLOR};
  GifByteType extension[4];
  const auto size = EGifGCBToExtension(&control, extension);
  check(EGifPutExtension(gif_.get(), GRAPHICS_EXT_FUNC_CODE, static_cast<int>(size), extension) ==
            GIF_OK &&
        EGifPutImageDesc(gif_.get(), left, top, right - left, bottom - top, false, nullptr) ==
            GIF_OK);
  for (int y = top; y < bottom; ++y)
    check(EGifPutLine(gif_.get(), &shown_[static_cast<std::size_t>(y) * columns_ + left],
                      right - left) == GIF_OK);
  ++pictures_;
}

void GifWriter::close() {
  if (waiting_) write(due(frame_ + 1));
  int error = 0;
  const bool good = EGifCloseFile(gif_.release(), &error) == GIF_OK;
  if (failure_) std::rethrow_exception(failure_);
  if (!good) throw OutputError(file_.path(), GifErrorString(error));
  file_.commit();
}

}  // namespace racebeam
