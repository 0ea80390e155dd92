// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/claim_arithmetic.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sc/beam/decision_datapath_core.h"
#include "sc/beam/ray_stepper.h"
#include "sc/beam/subdivider_core.h"
#include "tb/golden/golden_camera.h"

namespace racebeam {

namespace {

/// Values as they come.
struct Range {
  double sum = 0, least = std::numeric_limits<double>::infinity(), most = -least;
  std::int64_t count = 0;

  void add(double value) {
    sum += value;
    least = std::min(least, value);
    most = std::max(most, value);
    ++count;
  }
  double mean() const { return sum / double(count); }
};

// --- Bisection ---------------------------------------------------------------------------------

/// Probes of the subdivider between the ends of an interval of which the ray at its left end and
/// those up to `last` decide alike.
int probes(int length, int last, const knobs& k) {
  subdivider_core core;
  core.state_q = StateRight;
  core.i2_q = core.idx2_q = length;
  subdivider_core::inputs in{};
  in.mask = 1;
  for (int probed = 0;; ++probed) {
    in.dec = core.idx2_q > last;
    const subdivider_core::outputs out = core.comb(in, k);
    if (out.push) return probed;
    core.clock(in, out, k);
  }
}

/// Over all places of the switch in intervals of each length of a line.
Range bisection(const knobs& k) {
  Range all;
  Range by_length;
  for (int length = 1; length < VisibleColumns; ++length) {
    Range one;
    for (int last = 0; last < length; ++last) one.add(probes(length, last, k));
    by_length.add(one.mean());
    all.most = std::max(all.most, one.most);
  }
  by_length.most = all.most;
  return by_length;
}

// --- Walks -------------------------------------------------------------------------------------

/// Clocks in which the subdivider moves dr2 to a pixel.
int walk(int from, int to, const knobs& k) {
  subdivider_core core;
  core.state_q = StateLeft;
  core.idx2_q = from;
  core.i2_q = to;
  const subdivider_core::inputs in{};
  for (int steps = 0;; ++steps) {
    if (core.idx2_q == to) return steps;
    core.clock(in, core.comb(in, k), k);
  }
}

Range walks_of_a_line(const knobs& k) {
  Range all;
  for (int pixel = 1; pixel < VisibleColumns; ++pixel) all.add(walk(0, pixel, k));
  return all;
}

/// The camera's products: as many steps as pixels, their sign apart.
Range walks_of_a_factor(const knobs& k) {
  constexpr int Most = 512;
  Range all;
  for (int factor = -Most; factor < Most; ++factor) all.add(walk(0, std::abs(factor), k));
  return all;
}

// --- Steps without fractions -------------------------------------------------------------------

constexpr int Pixels = 1 << PixelBits, Deltas = 1 << DdrPortBits;

/// How far dr2 is from delta * i / 512, at each pixel i, stepped there by the ray_stepper.
template <class Take>
void each_step_error(const knobs& chip, const Take& take) {
  knobs k = chip;
  k.dr_bits = DrPortBits;  // nothing wraps
  const int half = 1 << chip.dr_bits;
  for (int delta = -half; delta < half; ++delta) {
    ray_stepper_core core;
    ray_stepper_core::inputs in{};
    in.step = true;
    in.step_size = 1;
    in.delta = {delta, delta, delta};
    for (int i = 0; i < Pixels; ++i) {
      take(delta, i, core.dr2_q[0] - double(delta) * i / (1 << DdrFractionBits));
      in.idx2 = i;
      core.clock(in, k);
    }
  }
}

Range step_errors(const knobs& k) {
  Range all;
  each_step_error(k, [&](int, int, double error) { all.add(error); });
  return all;
}

/// The most by which the errors of two pixels of a line differ.
double step_spread(const knobs& k) {
  double most = 0;
  Range line;
  each_step_error(k, [&](int, int i, double error) {
    if (i == 0) line = Range();
    if (i >= VisibleColumns) return;
    line.add(error);
    most = std::max(most, line.most - line.least);
  });
  return most;
}

/// The share of steps of one pixel whose extra term is this bit of delta, counted from the highest
/// of those below its whole part; those that have to wrap are none.
double extra_bit_share(int below) {
  int chosen = 0;
  for (int i = 0; i + 1 < Pixels; ++i)
    chosen += step_extra_bit(1 << (DdrFractionBits - 1 - below), 1, false, i);
  return double(chosen) / (Pixels - 1);
}

// --- Products ----------------------------------------------------------------------------------

constexpr int RayBits = 9;  // of a magnitude

/// What the multiplier is off by.
Range product_errors(const knobs& k) {
  Range all;
  for (int x = 0; x < 1 << RayBits; ++x)
    for (int m = 0; m < 1 << k.corner_factor_bits; ++m)
      all.add(double(product(x, m, k.partial_products_cut)) * (1 << k.partial_products_cut) -
              double(x) * m);
  return all;
}

/// Of the two products of a decision: the pairs of bits that count.
double partial_products(const knobs& k) {
  int kept = 0;
  for (int x = 0; x < RayBits; ++x)
    for (int m = 0; m < k.corner_factor_bits; ++m)
      kept += product(1 << x, 1 << m, k.partial_products_cut) != 0;
  return 2 * kept;
}

// --- The camera's angles -----------------------------------------------------------------------

/// By how much the camera's cosine is larger than that of the angle, over a quarter turn.
Range cosine_errors(const knobs& k) {
  constexpr int Quarter = 512;
  const GoldenVector straight = GoldenIdeal({0, 0, 0}, 0, CosineExact).ddr;
  const auto size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto along = std::max_element(straight.begin(), straight.end(), size) - straight.begin();
  Range all;
  for (int yaw = 0; yaw <= Quarter; ++yaw) {
    const auto cosine = [&](int rule) {
      return GoldenIdeal({yaw, 0, 0}, 0, rule).ddr.at(std::size_t(along)) /
             straight.at(std::size_t(along));
    };
    const double error = cosine(k.camera_cosine) - cosine(CosineExact);
    all.add(std::abs(error) < 1e-12 ? 0 : error);  // of the doubles
  }
  return all;
}

}  // namespace

const std::vector<ArithmeticFigure>& arithmetic_figures() {
  static const std::vector<ArithmeticFigure> table = {
      {"probes.mean", [](const knobs& k) { return bisection(k).mean(); }},
      {"probes.most", [](const knobs& k) { return bisection(k).most; }},
      {"walks.mean", [](const knobs& k) { return walks_of_a_line(k).mean(); }},
      {"walks.most", [](const knobs& k) { return walks_of_a_line(k).most; }},
      {"factors.mean", [](const knobs& k) { return walks_of_a_factor(k).mean(); }},
      {"factors.most", [](const knobs& k) { return walks_of_a_factor(k).most; }},
      {"steps.least", [](const knobs& k) { return step_errors(k).least; }},
      {"steps.mean", [](const knobs& k) { return step_errors(k).mean(); }},
      {"steps.most", [](const knobs& k) { return step_errors(k).most; }},
      {"steps.spread", step_spread},
      {"extra_bit.first", [](const knobs&) { return extra_bit_share(0); }},
      {"extra_bit.second", [](const knobs&) { return extra_bit_share(1); }},
      {"extra_bit.third", [](const knobs&) { return extra_bit_share(2); }},
      {"product.least", [](const knobs& k) { return product_errors(k).least; }},
      {"product.mean", [](const knobs& k) { return product_errors(k).mean(); }},
      {"product.most", [](const knobs& k) { return product_errors(k).most; }},
      {"partial_products", partial_products},
      {"cosine.least", [](const knobs& k) { return cosine_errors(k).least; }},
      {"cosine.most", [](const knobs& k) { return cosine_errors(k).most; }},
  };
  return table;
}

const ArithmeticFigure* arithmetic_figure(const std::string& name) {
  for (const ArithmeticFigure& figure : arithmetic_figures())
    if (name == figure.name) return &figure;
  return nullptr;
}

}  // namespace racebeam
