// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/value_noise.h"

#include <algorithm>
#include <cmath>

namespace racebeam {

namespace {

/// Each bit of the result depends on each bit of what is mixed.
std::uint32_t mixed(std::uint32_t v) {
  v ^= v >> 16;
  v *= 0x7feb352dU;
  v ^= v >> 15;
  v *= 0x846ca68bU;
  return v ^ v >> 16;
}

double smooth(double part) { return part * part * (3 - 2 * part); }
double between(double a, double b, double part) { return a + (b - a) * part; }

}  // namespace

std::uint32_t hash_of(std::uint32_t x, std::uint32_t y, std::uint32_t n, std::uint32_t seed) {
  return mixed(x + mixed(y + mixed(n + mixed(seed))));
}

ValueNoise::ValueNoise(int width, int height, int cell, int octaves, int seed)
    : width_(width),
      height_(height),
      across_(std::max(1, (width + cell / 2) / cell)),
      along_(std::max(1, (height + cell / 2) / cell)),
      octaves_(octaves),
      seed_(static_cast<std::uint32_t>(seed)) {}

double ValueNoise::octave(int n, double u, double v) const {
  const std::uint32_t across = static_cast<std::uint32_t>(across_) << n;
  const std::uint32_t along = static_cast<std::uint32_t>(along_) << n;
  u *= across;
  v *= along;
  const std::uint32_t i = static_cast<std::uint32_t>(u), j = static_cast<std::uint32_t>(v);
  const auto corner = [&](std::uint32_t x, std::uint32_t y) {
    return hash_of(x % across, y % along, static_cast<std::uint32_t>(n), seed_) / 4294967296.0;
  };
  const double part = smooth(u - i);
  return between(between(corner(i, j), corner(i + 1, j), part),
                 between(corner(i, j + 1), corner(i + 1, j + 1), part), smooth(v - j));
}

double ValueNoise::at(int x, int y) const {
  double sum = 0, weights = 0, weight = 1;
  for (int n = 0; n < octaves_; ++n, weight /= 2) {
    sum += weight * octave(n, x / width_, y / height_);
    weights += weight;
  }
  return sum / weights;
}

}  // namespace racebeam
