// What a scene of the block renderer is to the host, in floats, and to the cores, in 12.20.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "sc/base/engine.h"
#include "sc/base/fixed_point.h"
#include "sc/block/knobs.h"

namespace racebeam {

/// A sphere as the host has it; x right, y up, z away from the eye.
struct block_ball {
  std::array<float, 3> centre{};
  float radius = 0;
  std::array<float, 3> colour{};  ///< 0..1
};

/// What the host sends. The screen stands in the plane z = 0, its middle at the origin.
struct block_tables : scene_tables {
  std::array<float, 3> eye{0, 0, -7}, light{-8, 9, -9};
  std::array<float, 2> screen{8, 6};
  std::vector<block_ball> balls;  ///< 64 at most
};

/// A sphere as the cores have it, 12.20.
struct block_row {
  vec3 pose{};  ///< from the centre to the eye
  int rv = 0;   ///< radius2 - pose^2
  vec3 centre{};
  int radius = 0, radius2 = 0;
  vec3 colour{};
};

/// What the cores look at, 12.20.
struct block_world {
  vec3 eye{}, light{};
  vec3 start{};        ///< from the eye to the first pixel
  int ax = 0, ay = 0;  ///< from pixel to pixel, from row to row
  /// Of the angle from a block's middle to half a pixel beyond its corner, in the middle of the
  /// picture: its sine, and the square of its cosine.
  int cone_sine = 0, cone_cosine2 = 0;
  std::vector<block_row> rows;
};

/// The scene as block_convert makes it; the steps of the screen are the host's.
block_world converted(const block_tables& tables, const block_knobs& k);

}  // namespace racebeam
