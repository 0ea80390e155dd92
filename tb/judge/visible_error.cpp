// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/visible_error.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace racebeam {

namespace {

constexpr int Columns = VisibleColumns, Rows = VisibleRows;

// Pixels side by side that are looked at together; as an answer 0xff for yes.
using Pixels = std::uint8_t __attribute__((vector_size(16)));
constexpr int Size = sizeof(Pixels);
static_assert(Columns % Size == 0);

Pixels pixels_at(const std::uint8_t* from) {
  Pixels pixels;
  std::memcpy(&pixels, from, sizeof pixels);
  return pixels;
}

/// The pixels from x + side on, side -1..1; what is beyond the border repeats it.
Pixels pixels(const std::uint8_t* picture, int x, int row, int side) {
  const std::uint8_t* const from = picture + row * Columns + x;
  const bool left = side < 0 && x == 0, right = side > 0 && x == Columns - Size;
  if (!left && !right) return pixels_at(from + side);
  std::uint8_t repeated[Size + 2];
  std::memcpy(repeated + 1, from, Size);
  repeated[0] = from[0];
  repeated[Size + 1] = from[Size - 1];
  return pixels_at(repeated + 1 + side);
}

Pixels equal(Pixels a, Pixels b) { return reinterpret_cast<Pixels>(a == b); }

struct Halves {
  std::uint64_t low, high;
};
Halves halves(Pixels pixels) {
  Halves halves;
  std::memcpy(&halves, &pixels, sizeof halves);
  return halves;
}

bool any(Pixels answer) {
  const Halves of = halves(answer);
  return (of.low | of.high) != 0;
}

int number(Pixels answer) {
  constexpr std::uint64_t EachOne = 0x0101010101010101;
  const Halves of = halves(answer);
  return int(((of.low & EachOne) + (of.high & EachOne)) * EachOne >> 56);
}

/// Which of the `asked` pixels from (x, y) on have a colour in `of` that is near them in `in`.
Pixels near_ones(Pixels asked, const std::uint8_t* of, const std::uint8_t* in, int x, int y) {
  const Pixels colours = pixels(of, x, y, 0);
  Pixels found{};
  for (const int row : {std::max(y - 1, 0), y, std::min(y + 1, Rows - 1)})
    for (const int side : {-1, 0, 1}) found |= equal(pixels(in, x, row, side), colours);
  for (const int way : {-1, 1}) {
    if (y + 2 * way < 0 || y + 2 * way >= Rows) continue;
    for (const int side : {-1, 0, 1})
      found |= equal(pixels(in, x, y + 2 * way, side), colours) &
               equal(pixels(in, x, y + way, side), pixels(of, x, y + way, side));
  }
  return asked & found;
}

}  // namespace

int visible_difference(const GoldenPicture& a, const GoldenPicture& b) {
  // First where they differ, then how: no branch depends on pixels, as none could be foreseen.
  int places[Rows * Columns / Size];
  std::size_t count = 0;
  for (int at = 0; at < Rows * Columns; at += Size) {
    places[count] = at;
    count += any(pixels_at(&a[at]) ^ pixels_at(&b[at]));
  }
  int visible = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const int at = places[i], x = at % Columns, y = at / Columns;
    const Pixels differing = ~equal(pixels_at(&a[at]), pixels_at(&b[at]));
    const Pixels moved =
        near_ones(near_ones(differing, a.data(), b.data(), x, y), b.data(), a.data(), x, y);
    visible += number(differing & ~moved);
  }
  return visible;
}

}  // namespace racebeam
