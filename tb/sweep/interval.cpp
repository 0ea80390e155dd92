// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/interval.h"

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace racebeam {

namespace {

constexpr double Nan = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// With which factor a standard error becomes half of an interval.
double students_t(double degrees, double confidence) {
  return quantile(complement(boost::math::students_t(degrees), (1 - confidence) / 2));
}

double mean_of_values(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// Of the mean of a scene's frames.
double variance_of_mean(const Stratum& stratum) {
  const double n = double(stratum.values.size());
  if (int(n) == stratum.population) return 0;
  if (n < 2) return Infinity;
  double squares = 0;
  for (std::size_t i = 1; i < stratum.values.size(); ++i)
    squares += std::pow(stratum.values[i] - stratum.values[i - 1], 2);
  return squares / (2 * (n - 1) * n) * (1 - n / stratum.population);
}

/// Half of the interval of the mean over scenes. The degrees of freedom of several scenes are
/// Satterthwaite's; those of one are n - 1.
double half_width(const Strata& strata, double confidence) {
  double sum = 0, weights = 0;
  for (const Stratum& stratum : strata) {
    const double variance = variance_of_mean(stratum);
    if (variance == Infinity) return Infinity;
    if (variance == 0) continue;
    sum += variance;
    weights += variance * variance / (double(stratum.values.size()) - 1);
  }
  if (sum == 0) return 0;
  return students_t(sum * sum / weights, confidence) * std::sqrt(sum) / double(strata.size());
}

/// The frames that both have.
std::pair<Stratum, Stratum> common(const Stratum& b, const Stratum& a) {
  if (b.frames == a.frames) return {b, a};
  Stratum of_b, of_a;
  of_b.population = of_a.population = a.population;
  std::size_t j = 0;
  for (std::size_t i = 0; i < a.frames.size(); ++i) {
    while (j < b.frames.size() && b.frames[j] < a.frames[i]) ++j;
    if (j == b.frames.size()) break;
    if (b.frames[j] != a.frames[i]) continue;
    of_b.frames.push_back(b.frames[j]);
    of_b.values.push_back(b.values[j]);
    of_a.frames.push_back(a.frames[i]);
    of_a.values.push_back(a.values[i]);
  }
  return {of_b, of_a};
}

/// b - factor a, frame by frame.
Strata residual(Strata b, const Strata& a, double factor) {
  for (std::size_t scene = 0; scene < b.size(); ++scene)
    for (std::size_t i = 0; i < b[scene].values.size(); ++i)
      b[scene].values[i] -= factor * a[scene].values[i];
  return b;
}

}  // namespace

double for_best_of(int k, double confidence) { return 1 - (1 - confidence) / std::max(k, 1); }

std::pair<Strata, Strata> on_same_frames(const Strata& b, const Strata& a) {
  std::pair<Strata, Strata> both;
  for (std::size_t scene = 0; scene < a.size(); ++scene) {
    auto [of_b, of_a] = common(b.at(scene), a[scene]);
    both.first.push_back(std::move(of_b));
    both.second.push_back(std::move(of_a));
  }
  return both;
}

Estimate mean_of(const Strata& figure, double confidence) {
  Estimate mean;
  for (const Stratum& stratum : figure) {
    mean.value += mean_of_values(stratum.values);
    mean.frames += int(stratum.values.size());
    mean.population += stratum.population;
  }
  mean.value /= double(figure.size());
  mean.half_width = half_width(figure, confidence);
  return mean;
}

Estimate difference_of(const Strata& b, const Strata& a, double confidence) {
  const auto [of_b, of_a] = on_same_frames(b, a);
  return mean_of(residual(of_b, of_a, 1), confidence);
}

Estimate ratio_of(const Strata& b, const Strata& a, double confidence) {
  const auto [of_b, of_a] = on_same_frames(b, a);
  const double base = mean_of(of_a).value;
  Estimate ratio = mean_of(of_b);
  ratio.value = base == 0 ? Nan : ratio.value / base;
  ratio.half_width = Infinity;
  if (std::isnan(ratio.value)) return ratio;
  ratio.half_width = half_width(residual(of_b, of_a, ratio.value), confidence) / std::abs(base);
  return ratio;
}

Worst worst_of(const Strata& figure) {
  Worst worst;
  worst.value = Nan;
  for (std::size_t scene = 0; scene < figure.size(); ++scene) {
    const Stratum& stratum = figure[scene];
    worst.frames += int(stratum.values.size());
    worst.population += stratum.population;
    for (std::size_t i = 0; i < stratum.values.size(); ++i) {
      if (stratum.values[i] <= worst.value) continue;
      worst.value = stratum.values[i];
      worst.scene = int(scene);
      worst.frame = stratum.frames[i];
    }
  }
  return worst;
}

Share share_of(int hits, int frames, int population, double confidence) {
  Share share = {hits, frames, population};
  if (share.all()) {
    share.low = share.high = share.value();
    return share;
  }
  const double doubt = (1 - confidence) / 2;
  const auto end = [&](int a, int b, double p) {
    return quantile(boost::math::beta_distribution<>(a, b), p);
  };
  if (hits > 0) share.low = end(hits, frames - hits + 1, doubt);
  if (hits < frames) share.high = end(hits + 1, frames - hits, 1 - doubt);
  return share;
}

Share share_with_any(const Stratum& figure, double confidence) {
  const auto hits = std::count_if(figure.values.begin(), figure.values.end(),
                                  [](double value) { return value != 0; });
  return share_of(int(hits), int(figure.values.size()), figure.population, confidence);
}

}  // namespace racebeam
