// Means of frames with their intervals: of a figure, of a change, of a ratio.
//
// Frames are alike their neighbours, and a sample lies evenly over the scene (frame_order.h). So
// the variance of a mean comes from successive differences of the sample sorted by frame: sum of
// their squares / (2 (n - 1) n), times (1 - n / N); Student's t with n - 1 degrees of freedom.
// Frames of several scenes are strata: each scene weighs the same, whatever its length. Two points
// are compared on the frames that both have.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

namespace racebeam {

/// A figure in the frames of one scene that were taken.
struct Stratum {
  std::vector<int> frames;     ///< ascending
  std::vector<double> values;  ///< of each
  int population = 0;          ///< frames that may be taken
};
/// By scene.
using Strata = std::vector<Stratum>;

/// Below so many frames intervals of changes hold less often than they say (72 of 100 at the worst,
/// with 16 frames): no point is called better yet, only better so far.
constexpr int FramesOfAVerdict = 256;

/// `value` +/- `half_width`.
struct Estimate {
  double value = 0;                ///< not a number: there is no frame of some scene
  double half_width = 0;           ///< 0 if all frames were taken; infinite if one frame of many
  int frames = 0, population = 0;  ///< of all scenes

  bool all() const { return frames == population; }
  bool so_far() const { return !all() && frames < FramesOfAVerdict; }
  double low() const { return value - half_width; }
  double high() const { return value + half_width; }
  /// The interval lies on one side of `other`.
  bool differs_from(double other) const { return low() > other || high() < other; }
};

constexpr double Confidence = 0.95;

/// The confidence with which each of `k` intervals holds so that all of them hold with
/// `confidence` (Bonferroni): for the best of k.
double for_best_of(int k, double confidence = Confidence);

/// Both on the frames that both have. They have the same scenes.
std::pair<Strata, Strata> on_same_frames(const Strata& b, const Strata& a);

Estimate mean_of(const Strata& figure, double confidence = Confidence);
/// mean(b) - mean(a), frame by frame.
Estimate difference_of(const Strata& b, const Strata& a, double confidence = Confidence);
/// mean(b) / mean(a), from the differences of b - R a. Not a number if mean(a) is 0.
Estimate ratio_of(const Strata& b, const Strata& a, double confidence = Confidence);

/// The largest value of the frames taken. It has no interval: others may be worse.
struct Worst {
  double value = 0;                ///< not a number: there are no frames
  int scene = 0, frame = 0;        ///< the first with it
  int frames = 0, population = 0;  ///< looked at

  bool all() const { return frames == population; }
};
Worst worst_of(const Strata& figure);

/// A share of frames, from `hits` of `frames` of `population`: Clopper and Pearson's interval with
/// half of the doubt at each end, or exact if all frames were taken.
struct Share {
  int hits = 0, frames = 0, population = 0;
  double low = 0, high = 1;

  bool all() const { return frames == population; }
  double value() const { return double(hits) / frames; }
};
Share share_of(int hits, int frames, int population, double confidence = Confidence);
/// The share of frames in which the figure is not 0, in one scene.
Share share_with_any(const Stratum& figure, double confidence = Confidence);

}  // namespace racebeam
