// Arithmetic of the block renderer: signed 12.20 in 32 bits, sums and differences modulo 2^32,
// products rounded down. Roots and inverse roots are made from the bits of a float: in gates, a
// count of leading zeros, a shift and an adder.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "sc/base/fixed_point.h"
#include "sc/block/codes.h"
#include "sc/block/knobs.h"

namespace racebeam {

/// Modulo 2^32, signed.
constexpr int wrap32(std::int64_t value) {
  return static_cast<int>(static_cast<std::uint32_t>(value));
}
constexpr int block_sum(int a, int b) { return wrap32(std::int64_t{a} + b); }
constexpr int block_difference(int a, int b) { return wrap32(std::int64_t{a} - b); }

constexpr vec3 block_sum(const vec3& a, const vec3& b) {
  return {block_sum(a[0], b[0]), block_sum(a[1], b[1]), block_sum(a[2], b[2])};
}
constexpr vec3 block_difference(const vec3& a, const vec3& b) {
  return {block_difference(a[0], b[0]), block_difference(a[1], b[1]), block_difference(a[2], b[2])};
}

/// Bits 51..20 of the product.
constexpr int imul(int a, int b) { return wrap32(std::int64_t{a} * b >> BlockFraction); }
constexpr vec3 imul(const vec3& a, int s) { return {imul(a[0], s), imul(a[1], s), imul(a[2], s)}; }
/// Bits 51..20 of the sum of three products.
constexpr int idot(const vec3& a, const vec3& b) {
  std::uint64_t sum = 0;
  for (int k = 0; k < 3; ++k) sum += static_cast<std::uint64_t>(std::int64_t{a[k]} * b[k]);
  return wrap32(static_cast<std::int64_t>(sum >> BlockFraction));
}
constexpr int inorm2(const vec3& a) { return idot(a, a); }
constexpr int not_below_0(int value) { return value < 0 ? 0 : value; }

inline std::uint32_t float_bits(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}
inline float float_of_bits(std::uint32_t bits) {
  float value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/// block_root: the root of `d`, 0..2^23-1 (below 8.0), 0 to 6.07 % too long. Half of the float's
/// bits and a constant; in units of 2^-20, to nearest, ties to even.
inline int isqrt(int d) {
  const std::uint32_t half = float_bits(static_cast<float>(d) * 0x1p-20f) >> 1;
  return static_cast<int>(std::nearbyintf(float_of_bits(half + 0x1fc00000) * 0x1p20f));
}
/// The same with one step of Heron's; 0 of 0.
inline int heron_root(int d) {
  const int r = isqrt(d);
  return r ? static_cast<int>((r + (std::int64_t{d} << BlockFraction) / r) >> 1) : 0;
}
/// The root, cut at its last bit.
inline int exact_root(int d) {
  return static_cast<int>(std::sqrt(static_cast<double>(std::int64_t{d} << BlockFraction)));
}
/// As the knob `root` says.
inline int root_of(int d, int rule) {
  return rule == BlockRootTrick ? isqrt(d) : rule == BlockRootHeron ? heron_root(d) : exact_root(d);
}

/// The first estimate of 1 / sqrt(aa): of bits 29..6 alone; 3.5 % off at most. To units of 2^-14,
/// ties to even.
inline int inverse_root_estimate(int aa) {
  const int kept = aa >> 6 & low_bits(24);
  if (kept == 0) return 0x3759df << 6;  // the constant's own fraction
  const std::uint32_t half = float_bits(static_cast<float>(kept) * 0x1p-14f) >> 1;
  return static_cast<int>(std::nearbyintf(float_of_bits(0x5f3759df - half) * 0x1p14f)) << 6;
}
/// block_normalise in one piece: 1 / sqrt(aa) by the estimate and `steps` of Newton's.
inline int inverse_root(int aa, int steps) {
  int x = inverse_root_estimate(aa);
  for (int n = 0; n < steps; ++n)
    x = imul(x, block_difference(0x180000, imul(imul(x, x), aa >> 1)));
  return x;
}
inline vec3 inormalize(const vec3& v, int steps) { return imul(v, inverse_root(inorm2(v), steps)); }

/// A float of the host: to units of 2^-14, ties to even, for |value| < 256.
inline int f2i(float value) {
  const float moved = value + 768.0f;  // in [512, 1024) a float has 14 fraction bits
  if (!(moved >= 512.0f && moved < 1024.0f)) return 0;
  return (static_cast<int>(float_bits(moved) & 0x7fffff) - 0x400000) * 64;
}

}  // namespace racebeam
