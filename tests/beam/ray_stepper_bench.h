// ray_stepper on the bench, and what a step adds, in plain words.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <optional>
#include <random>

#include "sc/beam/ray_stepper.h"
#include "tb/twin/unit_bench.h"
#include "tests/support/own_rtl.h"

namespace racebeam {

/// floor(a / 2^k).
constexpr int floor_shift(int a, int k) {
  const int size = 1 << k;
  return a >= 0 ? a / size : -((size - 1 - a) / size);
}

/// Bit `n` of `a` in two's complement.
constexpr int bit(int a, int n) { return floor_shift(a, n) & 1; }

/// What dr2 has gained at pixel `i` (contract 8, "Consequence"), in units of 2^-stored.
inline int J(int ddr, int i, int stored = 0) {
  const int dropped = 9 - stored;
  int sum = 0;
  for (int k = 0; k <= 9; ++k)
    if (bit(i, k))
      sum += floor_shift(ddr * (1 << k), dropped) + (k < dropped ? bit(ddr, dropped - 1 - k) : 0);
  return sum;
}

/// What a step adds to dr2 (contract 8, rule 3; nothing set in the selected word: 18, item X).
inline int step_change(int ddr, int log2, bool neg, int idx2) {
  int b = log2;
  while (b < 10 && bit(idx2, b) != neg) ++b;
  if (b >= 10) b = 0;
  const int e = b <= 8 ? bit(ddr, 8 - b) : 0;
  return (neg ? -1 : 1) * (floor_shift(ddr * (1 << log2), 9) + e);
}

template <class Unit>
class RayStepperKnobTest : public testing::Test {
 protected:
  void build(const knobs& k) {
    dr_bits = k.dr_bits;
    unit.emplace("dut", k);
    bench.emplace(*unit);
  }

  UnitBench::Pin& pin(const char* name) { return (*bench)[name]; }
  vec3 dr1() { return bench->read("dr1"); }
  vec3 dr2() { return bench->read("dr2"); }
  vec3 wrapped(vec3 v) const {
    for (int& e : v) e = wrap_signed(e, dr_bits);
    return v;
  }
  vec3 change(const vec3& ddr, int log2, bool neg, int idx2) const {
    vec3 d;
    for (int a = 0; a < 3; ++a) d[a] = step_change(ddr[a], log2, neg, idx2);
    return d;
  }
  static vec3 add(vec3 v, const vec3& d) {
    for (int a = 0; a < 3; ++a) v[a] += d[a];
    return v;
  }

  /// One clock with all controls 0 afterwards.
  void pulse(std::initializer_list<const char*> names) {
    for (const char* name : names) pin(name).drive(1);
    bench->clock();
    for (const char* name : names) pin(name).drive(0);
  }
  void delta(const vec3& d) { bench->drive("delta", "_i", d); }

  /// dr2 := v, the way the camera does it: clear, then add.
  void put_dr2(const vec3& v) {
    pulse({"tracer_reset_i", "load_i", "load_zero_i"});
    delta(v);
    pin("axis_mask_i").drive(7);
    pin("ext_sign_i").drive(0);
    pulse({"tracer_reset_i", "ext_i"});
    ASSERT_EQ(dr2(), wrapped(v));
  }

  void step(int idx2, int pixels, bool neg) {
    pin("idx2_i").drive(idx2);
    pin("step_size_i").drive(pixels);
    pin("neg_i").drive(neg);
    pulse({"step_i"});
  }

  vec3 random_vector(int bits) {
    vec3 v;
    for (int& e : v) e = wrap_signed(static_cast<int>(random()), bits);
    return v;
  }
  int below(int limit) { return static_cast<int>(random() % limit); }

  /// Random steps that do not wrap idx2; after each, dr2 must be what `at` says for idx2.
  template <class Expected>
  void walk(int walks, bool powers_of_two, Expected at) {
    for (int n = 0; n < walks; ++n) {
      const vec3 dr_0 = random_vector(dr_bits), ddr = random_vector(dr_bits + 1);
      put_dr2(dr_0);
      delta(ddr);
      int idx2 = 0;
      for (int s = 0; s < 40; ++s) {
        const int pixels = powers_of_two ? 1 << below(10) : 1 + below(1023);
        const bool neg = below(2);
        const int to = neg ? idx2 - pixels : idx2 + pixels;
        if (to < 0 || to > 1023) continue;
        step(idx2, pixels, neg);
        idx2 = to;
        vec3 want;
        for (int a = 0; a < 3; ++a) want[a] = wrap_signed(at(dr_0[a], ddr[a], idx2), dr_bits);
        ASSERT_EQ(dr2(), want) << "walk " << n << ", step " << s << " to pixel " << idx2 << ", ddr "
                               << ddr[0] << "," << ddr[1] << "," << ddr[2];
      }
    }
  }
  /// The same walks with fractions stored.
  void expect_stored(int rule, int bits, bool powers_of_two) {
    knobs k;
    k.stepping = rule;
    k.stepping_fraction_bits = bits;
    k.bisection = powers_of_two ? BisectionPow2 : BisectionMidpoint;
    build(k);
    walk(150, powers_of_two,
         [bits](int dr_0, int ddr, int i) { return dr_0 + floor_shift(J(ddr, i, bits), bits); });
  }
  static int without_fraction(int dr_0, int ddr, int i) { return dr_0 + J(ddr, i); }

  int dr_bits = 10;
  std::mt19937 random{20240607};
  std::optional<Unit> unit;
  std::optional<UnitBench> bench;
};

using Twins = testing::Types<ray_stepper, own_rtl<ray_stepper>>;

}  // namespace racebeam
