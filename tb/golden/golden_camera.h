// The rays of a line in closed form: the chip's integer rays, and the ideal camera's.
//
// Sources: contract 7.1 (the vectors), 7.5 and 17.3 (the demo's angles), 8 (what the ray_stepper
// adds). No step of the chip's camera is repeated here: products and sums are written down at once.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "sc/base/constants.h"
#include "sc/base/fixed_point.h"
#include "sc/beam/knobs.h"
#include "tb/scene/scene_file.h"

namespace racebeam {

/// What ray_stepper has added at pixel `i` when it steps by `delta` / 512 a pixel (contract 8).
int golden_steps(int delta, int i);

/// Where a line looks: yaw and pitch in 1/2048 turn, focal length in pixels.
struct GoldenView {
  int yaw, pitch, fov;
};

/// How the view moves from frame to frame and from line to line.
struct GoldenTurns {
  Turn yaw, pitch, fov;

  GoldenView view(int frame, int y) const;
};

/// The view of a line of the demo, for a rotation variant, and where the rotation is fast or not.
GoldenView golden_view(int frame, int variant, bool fast, int y);

/// Ray direction of pixel 0 and its change per pixel in 1/512.
struct GoldenLine {
  vec3 dr_0, ddr;
};

/// The chip's line `y` with the rounding of all its products; `cosine`: a cosine_rule.
GoldenLine golden_line(const GoldenView& view, int y, int cosine = CosineParabola);

/// Directions in double precision.
using GoldenVector = std::array<double, 3>;

/// The ideal camera of a line: the same parabolas for sine and cosine, or exact ones, without any
/// rounding.
struct GoldenIdeal {
  GoldenVector dr_0, ddr;  ///< direction of pixel 0, change per pixel

  GoldenIdeal(const GoldenView& view, int y, int cosine = CosineParabola);
  GoldenVector ray(int pixel) const;
};

/// The chip's ray directions of all pixels of a line.
using GoldenRays = std::array<vec3, VisibleColumns>;

/// The camera of one frame of the demo or of a scene file. Of the knobs counts camera_cosine; rays
/// have 10 bits and the chip's stepping, whatever dr_bits and stepping say.
class GoldenCamera {
 public:
  explicit GoldenCamera(int frame, const knobs& k = {});
  GoldenCamera(const SceneFile& scene, int frame, const knobs& k = {});

  GoldenView view(int y) const { return turns_.view(frame_, y); }
  GoldenRays rays(int y) const;
  GoldenIdeal ideal(int y) const { return {view(y), y, cosine_}; }

 private:
  int frame_, cosine_;
  GoldenTurns turns_;
};

}  // namespace racebeam
