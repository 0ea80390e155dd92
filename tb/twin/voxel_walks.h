// BuildWalk: voxel_builder through the whole default world.
// PictureWalk: voxel_scan to the end of a picture of the default scene.
// RayWalk: voxel_walker along rays whose numbers are close to each other.
//
// Random traffic builds rectangles of a few columns, sees a few hundred pixels, and has rays that
// leave the world at once.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "sc/base/knob_values.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

class BuildWalk {
 public:
  /// More than 300,000 for the world, then small rectangles all over it.
  static constexpr std::uint64_t World = 340'000, Clocks = World + 80'000;

  /// For voxel_builder on `bench`; the same seed makes the same traffic.
  BuildWalk(UnitBench& bench, const knob_values& k, unsigned seed);

  /// New values for the next clock.
  void next();

 private:
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }
  void choose_rectangle();

  UnitBench& bench_;
  const int size_x_, size_y_;
  std::mt19937 random_;
  std::uint64_t clock_ = 0;
};

class PictureWalk {
 public:
  /// For three pictures of the default scene: a little more than two for a pixel.
  static constexpr std::uint64_t Clocks = 20'000;

  /// For voxel_scan on `bench`; the same seed makes the same traffic.
  PictureWalk(UnitBench& bench, const knob_values&, unsigned seed) : bench_(bench), random_(seed) {}

  /// New values for the next clock.
  void next();

 private:
  bool one_in(int count) { return random_() % static_cast<unsigned>(count) == 0; }

  UnitBench& bench_;
  std::mt19937 random_;
  bool begun_ = false;
};

/// Ways are as long as coordinates are apart, so that borders are met at the same place, or almost.
class RayWalk {
 public:
  static constexpr std::uint64_t Clocks = 400'000;

  /// For voxel_walker on `bench`; the same seed makes the same traffic.
  RayWalk(UnitBench& bench, const knob_values&, unsigned seed) : bench_(bench), random_(seed) {}

  /// New values for the next clock.
  void next();

 private:
  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }
  bool one_in(int count) { return below(count) == 0; }
  void begin_ray();
  void drive(const std::string& port, std::int64_t value);
  std::int64_t coordinate();
  std::int64_t direction();
  std::int64_t inverse();

  UnitBench& bench_;
  std::mt19937 random_;
  bool begun_ = false;
  int left_ = 0;     // clocks of the ray
  int filled_ = 0;   // of 4 words so many are full
  int limited_ = 1;  // a limit is reached once in so many clocks
};

}  // namespace racebeam
