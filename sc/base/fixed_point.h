// Two's complement arithmetic of up to 31 bits on plain ints, and the three axes of a vector. Ports
// may have 64 bits.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace racebeam {

/// Values of the x, y and z axis (0, 1, 2).
using vec3 = std::array<int, 3>;

/// All ones in the low `bits` bits, 0..31.
constexpr int low_bits(int bits) { return static_cast<int>((1u << bits) - 1u); }

/// The value of `raw` modulo 2^bits as a signed number of that width.
constexpr int wrap_signed(int raw, int bits) {
  const int shift = 32 - bits;
  return static_cast<int>(static_cast<std::uint32_t>(raw) << shift) >> shift;
}

/// The low `bits` bits of `value`, 1..64.
constexpr std::uint64_t raw_bits(std::uint64_t value, int bits) {
  return value & (~std::uint64_t{0} >> (64 - bits));
}

/// The low `bits` bits of `raw`, 1..64, as a signed number.
constexpr std::int64_t signed_bits(std::uint64_t raw, int bits) {
  const int shift = 64 - bits;
  return static_cast<std::int64_t>(raw << shift) >> shift;
}

/// A signed number of `from` bits as one of `to` bits: low bits are dropped or 0.
constexpr int rescaled(int value, int from, int to) {
  return from >= to ? value >> (from - to) : value * (1 << (to - from));
}

/// Bit `index` of `word`.
constexpr bool bit_of(int word, int index) { return (word >> index) & 1; }

}  // namespace racebeam
