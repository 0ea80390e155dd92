// The weights of the sphere tracer's sub-rays beside others: the design's five figures.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "tb/golden/sphere_golden.h"

namespace racebeam {
namespace {

using Weights = std::array<double, 3>;  // of the middle, the corners, the edges of a pixel
using Colour = std::array<double, 3>;

void add(Colour& to, const Colour& ray, double weight) {
  for (std::size_t n = 0; n < 3; ++n) to[n] += ray[n] * weight;
}

/// The error of weighted sub-rays against 64 rays a pixel, in levels of 31, in 210 x 200 pixels
/// around the spheres of scene four.
class Errors {
 public:
  Errors() {
    SphereGoldenScene scene;
    scene.spheres = builtin_spheres(false);
    const SphereGolden golden(scene);
    for (int y = 120; y < 320; ++y)
      for (int x = 140; x < 350; ++x) {
        Pixel p{};
        p.middle = golden.ray(x, y);
        for (const double one : {-0.5, 0.5}) {
          for (const double other : {-0.5, 0.5}) add(p.corners, golden.ray(x + one, y + other), 1);
          add(p.edges, golden.ray(x + one, y), 1);
          add(p.edges, golden.ray(x, y + one), 1);
        }
        for (int n = 0; n < 64; ++n)
          add(p.fine, golden.ray(x + (n % 8 - 3.5) / 8, y + (n / 8 - 3.5) / 8), 1.0 / 64);
        pixels_.push_back(p);
      }
  }
  double of(const Weights& weights) const {
    double squares = 0;
    for (const Pixel& p : pixels_)
      for (std::size_t n = 0; n < 3; ++n) {
        const double is =
            p.middle[n] * weights[0] + p.corners[n] * weights[1] + p.edges[n] * weights[2];
        squares += (is - p.fine[n]) * (is - p.fine[n]);
      }
    return std::sqrt(squares / static_cast<double>(3 * pixels_.size())) / 32;
  }

 private:
  struct Pixel {
    Colour middle, corners, edges, fine;
  };
  std::vector<Pixel> pixels_;
};

TEST(SphereAntialias, TheChipsWeightsWin) {
  const Errors errors;
  constexpr double Digit = 0.0005;  // the last one of the design's figures
  EXPECT_NEAR(errors.of({1, 0, 0}), 0.383, Digit) << "one ray";
  EXPECT_NEAR(errors.of({0.2, 0.2, 0}), 0.233, Digit) << "five alike";
  EXPECT_NEAR(errors.of({0.5, 0.125, 0}), 0.187, Digit) << "4x";
  EXPECT_NEAR(errors.of({1 / 9., 1 / 9., 1 / 9.}), 0.170, Digit) << "nine alike";
  EXPECT_NEAR(errors.of({0.25, 0.0625, 0.125}), 0.123, Digit) << "8x";
}

}  // namespace
}  // namespace racebeam
