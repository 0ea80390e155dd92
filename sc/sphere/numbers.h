// Arithmetic of the sphere tracer: signed 12.12 in 24 bits, sums of products in 48.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "sc/base/fixed_point.h"
#include "sc/sphere/codes.h"

namespace racebeam {

/// Modulo 2^24, signed.
constexpr int wrap24(int value) { return wrap_signed(value, SphereBits); }
constexpr vec3 wrap24(int x, int y, int z) { return {wrap24(x), wrap24(y), wrap24(z)}; }
/// Modulo 2^48, signed.
constexpr std::int64_t wrap48(std::int64_t value) {
  return signed_bits(static_cast<std::uint64_t>(value), SphereSumBits);
}
/// Bits 35..12 of a sum, signed: rounded down.
constexpr int floor24(std::int64_t sum) { return wrap24(static_cast<int>(sum >> SphereFraction)); }

constexpr vec3 difference(const vec3& a, const vec3& b) {
  return wrap24(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}
constexpr vec3 sum_of(const vec3& a, const vec3& b) {
  return wrap24(a[0] + b[0], a[1] + b[1], a[2] + b[2]);
}
constexpr std::int64_t dot(const vec3& a, const vec3& b) {
  std::int64_t sum = 0;
  for (int k = 0; k < 3; ++k) sum += static_cast<std::int64_t>(a[k]) * b[k];
  return wrap48(sum);
}
/// The floor of a times s, per axis.
constexpr vec3 scaled(const vec3& a, int s) {
  vec3 p{};
  for (int k = 0; k < 3; ++k) p[k] = floor24(static_cast<std::int64_t>(a[k]) * s);
  return p;
}

/// The bits that a number of `fraction_bits` fraction bits keeps.
constexpr int kept_bits(int fraction_bits) { return ~low_bits(SphereFraction - fraction_bits); }
constexpr vec3 masked(const vec3& v, int mask) { return {v[0] & mask, v[1] & mask, v[2] & mask}; }

/// A sixteenth of the way to the light; the differences have 25 bits.
constexpr vec3 towards_light(const vec3& light, const vec3& point, int mask) {
  return masked(
      {(light[0] - point[0]) >> 4, (light[1] - point[1]) >> 4, (light[2] - point[2]) >> 4}, mask);
}

/// What the root of a ray's squared length is taken of, from the sum: it saturates.
constexpr bool length_overflows(std::int64_t sum) { return (sum >> 36 & 0xfff) != 0; }
constexpr int length_radicand(std::int64_t sum) {
  return length_overflows(sum) ? low_bits(SphereBits)
                               : static_cast<int>(sum >> SphereFraction & low_bits(SphereBits));
}

/// root_unit in one piece: floor(sqrt(radicand * 2^12)); exact, as 36 bits fit a double.
inline int root_of(int radicand) {
  return static_cast<int>(
      std::sqrt(static_cast<double>(static_cast<std::int64_t>(radicand) << 12)));
}
/// divider_unit in one piece, a lane: `numerator` of 36 bits, `denominator` of 24, signed.
constexpr int quotient_of(std::int64_t numerator, int denominator) {
  if (denominator == 0) return numerator < 0 ? -0x7fffff : 0x7fffff;
  return wrap24(static_cast<int>(numerator / denominator));
}

}  // namespace racebeam
