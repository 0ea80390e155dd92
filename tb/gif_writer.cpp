// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/gif_writer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace racebeam {
namespace {

constexpr int ColourBits = 6, Colours = 1 << ColourBits;
constexpr int ClearCode = Colours, EndCode = Colours + 1, FirstCode = Colours + 2;
constexpr int CodeLimit = 4096;

/// Packs codes of growing width, low bit first, into blocks of up to 255 bytes.
class CodePacker {
 public:
  explicit CodePacker(std::vector<std::uint8_t>& out) : out_(out) {}

  void put(int code, int width) {
    bits_ |= static_cast<std::uint32_t>(code) << filled_;
    for (filled_ += width; filled_ >= 8; filled_ -= 8, bits_ >>= 8) put_byte();
  }
  void finish() {
    if (filled_ > 0) put_byte();
    if (block_size_ > 0) out_[out_.size() - block_size_ - 1] = block_size_;
    out_.push_back(0);
  }

 private:
  void put_byte() {
    if (block_size_ == 0) out_.push_back(255);  // size of a full block; finish() corrects the last
    out_.push_back(static_cast<std::uint8_t>(bits_));
    if (++block_size_ == 255) block_size_ = 0;
  }

  std::vector<std::uint8_t>& out_;
  std::uint32_t bits_ = 0;
  int filled_ = 0;
  std::uint8_t block_size_ = 0;
};

int checked(int value, int max, const char* name) {
  if (value < 1 || value > max) throw std::invalid_argument(std::string("GIF: bad ") + name);
  return value;
}

int delay_of(double frames_per_second) {
  if (!(frames_per_second > 0)) throw std::invalid_argument("GIF: bad frames per second");
  return static_cast<int>(std::clamp(std::round(100 / frames_per_second), 2.0, 65535.0));
}

}  // namespace

GifWriter::GifWriter(const std::string& path, int width, int height, double frames_per_second,
                     int downscale)
    : file_(path),
      width_(checked(width, 65535, "width")),
      height_(checked(height, 65535, "height")),
      downscale_(checked(downscale, std::min(width, height), "downscale")),
      columns_(width / downscale),
      rows_(height / downscale),
      delay_(delay_of(frames_per_second)),
      shown_(static_cast<std::size_t>(columns_) * rows_),
      next_(shown_.size()) {
  for (const char c : {'G', 'I', 'F', '8', '9', 'a'}) bytes_.push_back(c);
  put_16(columns_);
  put_16(rows_);
  bytes_.insert(bytes_.end(), {0x80 | (ColourBits - 1) << 4 | (ColourBits - 1), 0, 0});
  for (int colour = 0; colour < Colours; ++colour)
    for (const int shift : {4, 2, 0})
      bytes_.push_back(static_cast<std::uint8_t>((colour >> shift & 3) * 85));
  bytes_.insert(bytes_.end(), {0x21, 0xff, 11});  // extension: repeat for ever
  for (const char c : {'N', 'E', 'T', 'S', 'C', 'A', 'P', 'E', '2', '.', '0'}) bytes_.push_back(c);
  bytes_.insert(bytes_.end(), {3, 1, 0, 0, 0});
}

void GifWriter::put_16(int value) {
  bytes_.push_back(static_cast<std::uint8_t>(value & 255));
  bytes_.push_back(static_cast<std::uint8_t>(value >> 8));
}

void GifWriter::add(const std::vector<std::uint8_t>& colours) {
  if (colours.size() != static_cast<std::size_t>(width_) * height_)
    throw std::invalid_argument("GIF: the frame has another size");
  // Only the box that changed is written.
  int left = columns_, top = rows_, right = 0, bottom = 0;
  for (int y = 0; y < rows_; ++y)
    for (int x = 0; x < columns_; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * columns_ + x;
      const std::size_t from = (static_cast<std::size_t>(y) * width_ + x) * downscale_;
      next_[i] = colours[from] & (Colours - 1);
      if (frames_ > 0 && next_[i] == shown_[i]) continue;
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
  put_image(left, top, right - left, bottom - top);
  file_.write(bytes_.data(), bytes_.size());
  bytes_.clear();
  ++frames_;
}

void GifWriter::put_image(int left, int top, int width, int height) {
  bytes_.insert(bytes_.end(), {0x21, 0xf9, 4, 1 << 2});  // extension: keep the picture, delay
  put_16(delay_);
  bytes_.insert(bytes_.end(), {0, 0, 0x2c});
  for (const int value : {left, top, width, height}) put_16(value);
  bytes_.push_back(0);
  put_codes(left, top, width, height);
}

/// LZW.
void GifWriter::put_codes(int left, int top, int width, int height) {
  bytes_.push_back(ColourBits);
  CodePacker packer(bytes_);
  int next = FirstCode, bits = ColourBits + 1;
  const auto clear = [&] {
    packer.put(ClearCode, bits);
    longer_.assign(CodeLimit * Colours, 0);
    next = FirstCode;
    bits = ColourBits + 1;
  };
  clear();
  int known = -1;  // code of the longest known string so far
  for (int y = top; y < top + height; ++y)
    for (int x = left; x < left + width; ++x) {
      const int colour = shown_[static_cast<std::size_t>(y) * columns_ + x];
      if (known < 0) {
        known = colour;
        continue;
      }
      std::uint16_t& code = longer_[known * Colours + colour];
      if (code == 0) {
        packer.put(known, bits);
        if (next == 1 << bits) ++bits;
        code = static_cast<std::uint16_t>(next);
        known = colour;
        if (++next == CodeLimit) clear();
      } else {
        known = code;
      }
    }
  packer.put(known, bits);
  if (next == 1 << bits) ++bits;  // the reader has counted this code too
  packer.put(EndCode, bits);
  packer.finish();
}

void GifWriter::close() {
  bytes_.push_back(0x3b);
  file_.write(bytes_.data(), bytes_.size());
  file_.commit();
}

}  // namespace racebeam
