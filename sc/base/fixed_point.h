// Two's complement arithmetic of any width on plain ints, and the three axes of a vector.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace racebeam {

/// Values of the x, y and z axis (0, 1, 2).
using vec3 = std::array<int, 3>;

/// All ones in the low `bits` bits.
constexpr int low_bits(int bits) { return static_cast<int>((1u << bits) - 1u); }

/// The value of `raw` modulo 2^bits as a signed number of that width.
constexpr int wrap_signed(int raw, int bits) {
  const int shift = 32 - bits;
  return static_cast<int>(static_cast<std::uint32_t>(raw) << shift) >> shift;
}

/// A signed number of `from` bits as one of `to` bits: low bits are dropped or 0.
constexpr int rescaled(int value, int from, int to) {
  return from >= to ? value >> (from - to) : value * (1 << (to - from));
}

/// Bit `index` of `word`.
constexpr bool bit_of(int word, int index) { return (word >> index) & 1; }

}  // namespace racebeam
