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

// Pixels side by side, a byte each, the leftmost in the lowest: they are looked at together.
using Word = std::uint64_t;
constexpr int Size = sizeof(Word);
constexpr Word EachOne = 0x0101010101010101, Bit = 0x80 * EachOne;
static_assert(Columns % Size == 0);

Word word_at(const std::uint8_t* pixels) {
  Word word;
  std::memcpy(&word, pixels, sizeof word);
  return le64toh(word);
}

/// The pixels from x + side on, side -1..1; what is beyond the border repeats it.
Word word(const std::uint8_t* picture, int x, int row, int side) {
  const std::uint8_t* const pixels = picture + row * Columns + x;
  if (side < 0 && x == 0) return word_at(pixels) << 8 | pixels[0];
  if (side > 0 && x == Columns - Size)
    return word_at(pixels) >> 8 | Word{pixels[Size - 1]} << (8 * (Size - 1));
  return word_at(pixels + side);
}

/// Not 0 in the bytes that are equal: colours have six bits, so no byte carries into the next.
Word equal(Word a, Word b) { return ~((a ^ b) + 0x7f * EachOne) & Bit; }

/// Which of the `asked` pixels from (x, y) on have a colour in `of` that is near them in `in`.
Word near_ones(Word asked, const std::uint8_t* of, const std::uint8_t* in, int x, int y) {
  const Word colours = word(of, x, y, 0);
  Word found = 0;
  for (const int row : {y, std::max(y - 1, 0), std::min(y + 1, Rows - 1)}) {
    for (const int side : {0, -1, 1}) found |= equal(word(in, x, row, side), colours);
    if (!(asked & ~found)) return asked;
  }
  for (const int way : {-1, 1}) {
    if (y + 2 * way < 0 || y + 2 * way >= Rows) continue;
    for (const int side : {-1, 0, 1})
      found |= equal(word(in, x, y + 2 * way, side), colours) &
               equal(word(in, x, y + way, side), word(of, x, y + way, side));
  }
  return asked & found;
}

}  // namespace

int visible_difference(const GoldenPicture& a, const GoldenPicture& b) {
  constexpr int Part = 8 * Size;  // most parts of a line are equal
  static_assert(Columns % Part == 0);
  int visible = 0;
  for (int at = 0; at < Rows * Columns; at += Size) {
    if (at % Part == 0 && std::memcmp(&a[at], &b[at], Part) == 0) {
      at += Part - Size;
      continue;
    }
    const Word here_a = word_at(&a[at]), here_b = word_at(&b[at]);
    if (here_a == here_b) continue;
    const int x = at % Columns, y = at / Columns;
    const Word differing = ~equal(here_a, here_b) & Bit;
    const Word both =
        near_ones(near_ones(differing, a.data(), b.data(), x, y), b.data(), a.data(), x, y);
    if (const Word seen = differing & ~both) visible += __builtin_popcountll(seen);
  }
  return visible;
}

}  // namespace racebeam
