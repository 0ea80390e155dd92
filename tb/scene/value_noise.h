// ValueNoise: smooth random numbers on a plane that repeats, octaves of them added up; the same
// from the same seed on every machine.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace racebeam {

/// A number that looks random, of three and a seed.
std::uint32_t hash_of(std::uint32_t x, std::uint32_t y, std::uint32_t n, std::uint32_t seed);

class ValueNoise {
 public:
  /// On a plane of width x height that repeats. Its coarsest octave has a random number every
  /// `cell` or so; each further one has twice as many and counts half as much.
  ValueNoise(int width, int height, int cell, int octaves, int seed);

  /// 0..1.
  double at(int x, int y) const;

 private:
  double octave(int n, double u, double v) const;

  double width_, height_;
  int across_, along_;  // cells of the coarsest octave
  int octaves_;
  std::uint32_t seed_;
};

}  // namespace racebeam
