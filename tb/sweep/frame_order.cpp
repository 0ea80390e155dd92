// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/frame_order.h"

#include <random>

namespace racebeam {

namespace {

/// vdc(i) * 2^32: the bits of `i` in reverse.
std::uint32_t van_der_corput(std::uint32_t i) {
  std::uint32_t reversed = 0;
  for (int bit = 0; bit < 32; ++bit) reversed |= (i >> bit & 1U) << (31 - bit);
  return reversed;
}

}  // namespace

std::vector<int> frame_order(const std::vector<int>& allowed, std::uint64_t seed) {
  const std::uint32_t start = static_cast<std::uint32_t>(std::mt19937_64(seed)() >> 32);
  std::vector<int> order;
  std::vector<bool> taken(allowed.size());
  // 2^k >= N numbers hit each of N equal parts, so this ends before twice as many.
  for (std::uint32_t i = 0; order.size() < allowed.size(); ++i) {
    const std::uint32_t place = van_der_corput(i) + start;  // frac: modulo 2^32
    const std::size_t n = allowed.size() * std::uint64_t{place} >> 32;
    if (taken[n]) continue;
    taken[n] = true;
    order.push_back(allowed[n]);
  }
  return order;
}

}  // namespace racebeam
