// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/visible_error.h"

#include <endian.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace racebeam {

namespace {

constexpr int Columns = VisibleColumns, Rows = VisibleRows;

using Three = std::uint32_t;  // pixels side by side, a byte each
constexpr Three EachOne = 0x010101;

/// The pixels x - 1 .. x + 1 of a row; what is beyond the border repeats it.
Three three(const std::uint8_t* picture, int x, int row) {
  const std::uint8_t* const pixels = picture + row * Columns;
  if (x == 0 || x >= Columns - 2)
    return pixels[std::max(x - 1, 0)] | pixels[x] << 8 | pixels[std::min(x + 1, Columns - 1)] << 16;
  Three four;
  std::memcpy(&four, pixels + x - 1, sizeof four);
  return le32toh(four) & 0xff * EachOne;
}

/// Not 0 in the bytes that are equal: colours have six bits, so no byte carries into the next.
Three equal(Three a, Three b) { return ~((a ^ b) + 0x7f * EachOne) & 0x80 * EachOne; }

/// Whether the colour of pixel (x, y) in `of` is near it in `in`.
bool is_near(const std::uint8_t* of, const std::uint8_t* in, int x, int y) {
  const Three colour = of[y * Columns + x] * EachOne;
  const auto here = [&](int row) { return equal(three(in, x, row), colour); };
  const auto right = [&](int row) { return equal(three(in, x, row), three(of, x, row)); };
  if (here(y) || here(std::max(y - 1, 0)) || here(std::min(y + 1, Rows - 1))) return true;
  return (y > 1 && here(y - 2) & right(y - 1)) || (y + 2 < Rows && here(y + 2) & right(y + 1));
}

}  // namespace

int visible_difference(const GoldenPicture& a, const GoldenPicture& b) {
  using Word = std::uint64_t;  // pixels that are looked at together, as most are equal
  static_assert(Columns % sizeof(Word) == 0);
  int visible = 0;
  for (int y = 0; y < Rows; ++y)
    for (int x = 0; x < Columns; x += sizeof(Word)) {
      const std::size_t at = static_cast<std::size_t>(y) * Columns + x;
      if (std::memcmp(&a[at], &b[at], sizeof(Word)) == 0) continue;
      for (int i = x; i < x + static_cast<int>(sizeof(Word)); ++i)
        visible += a[at + i - x] != b[at + i - x] &&
                   !(is_near(a.data(), b.data(), i, y) && is_near(b.data(), a.data(), i, y));
    }
  return visible;
}

}  // namespace racebeam
