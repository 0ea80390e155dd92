// Promises of sc/beam/ray_stepper.h: contract section 8.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/ray_stepper.h"

#include <gtest/gtest.h>

#include "tests/beam/ray_stepper_bench.h"

namespace racebeam {
namespace {

template <class Unit>
class RayStepperTest : public RayStepperKnobTest<Unit> {
 protected:
  RayStepperTest() { this->build({}); }
};

TYPED_TEST_SUITE(RayStepperTest, Twins);

// Contract 8, micro-trace of frame 2, y = -240, all axes (ddr of contract 20.1).
TYPED_TEST(RayStepperTest, FirstStepsOfALineFollowTheMicroTrace) {
  this->put_dr2({-319, -239, 95});
  this->delta({511, 0, 0});
  this->step(0, 512, false);
  EXPECT_EQ(this->dr2(), (vec3{192, -239, 95}));
  this->step(512, 128, false);
  EXPECT_EQ(this->dr2(), (vec3{320, -239, 95}));
  this->step(640, 1, true);
  EXPECT_EQ(this->dr2(), (vec3{319, -239, 95}));
}

// As in the article's appendix: J with 8 fraction bits; with 9 of them delta is twice as large.
TYPED_TEST(RayStepperTest, JumpsGiveTheVectorsOfTheSeed) {
  const int rows[][3] = {{43, 43, 6},     {171, 213, 144},   {-341, 213, -282}, {-469, 43, -80},
                         {205, 639, 512}, {-205, 639, -512}, {409, 320, 511}};
  for (const auto& [a, i, sum] : rows) {
    this->put_dr2({});
    this->delta({2 * a, 2 * a, 0});
    for (int k = 0, idx2 = 0; k < 10; ++k) {
      if (!(i >> k & 1)) continue;
      this->step(idx2, 1 << k, false);
      idx2 += 1 << k;
    }
    const int dr = wrap_signed(sum, 10);
    EXPECT_EQ(this->dr2(), (vec3{dr, dr, 0})) << a << " * " << i;
  }
}

TYPED_TEST(RayStepperTest, StepsGiveTheVectorsOfTheSeed) {
  const int rows[][5] = {
      {-91, 12, 2, -2, 1}, {255, 96, 5, 32, -32}, {205, 319, 6, 51, -51}, {170, 5, 0, 0, -1}};
  for (const auto& [a, i, n, up, down] : rows)
    for (const bool neg : {false, true}) {
      this->put_dr2({10, -10, 0});
      this->delta({2 * a, 2 * a, 2 * a});
      this->step(i, 1 << n, neg);
      const int change = neg ? down : up;
      EXPECT_EQ(this->dr2(), (vec3{10 + change, -10 + change, change}))
          << a << " " << i << " " << n;
    }
}

// Contract 8, "Consequence": dr2 = dr_0 + J(idx2) whatever the order of steps.
TYPED_TEST(RayStepperTest, DirectionDependsOnThePixelAndNotOnTheWayToIt) {
  this->walk(400, true, this->without_fraction);
}

// Contract 8, rule 3 for every size and direction, also where the step wraps idx2 (18, item X) and
// for 1024 pixels, where idx2 does not move (9.6).
TYPED_TEST(RayStepperTest, EveryStepFollowsTheRuleAlsoWhereIdx2Wraps) {
  int wraps = 0;
  for (int n = 0; n < 20000; ++n) {
    const vec3 ddr = this->random_vector(11);
    const int log2 = this->below(11), idx2 = n % 4 ? this->below(1024) : (n & 4 ? 0 : 1023);
    const bool neg = this->below(2);
    const vec3 before = this->dr2();
    this->delta(ddr);
    this->step(idx2, 1 << log2, neg);
    const int to = neg ? idx2 - (1 << log2) : idx2 + (1 << log2);
    wraps += to < 0 || to > 1023;
    ASSERT_EQ(this->dr2(), this->wrapped(this->add(before, this->change(ddr, log2, neg, idx2))))
        << "delta x " << ddr[0] << ", log2 " << log2 << ", neg " << neg << ", idx2 " << idx2;
  }
  EXPECT_GT(wraps, 1000);
}

// Contract 8, all rules in their priority, with random pins against a plain reference.
TYPED_TEST(RayStepperTest, PrioritiesHoldForRandomControls) {
  vec3 dr1{}, dr2{};
  this->pulse({"tracer_reset_i", "load_i", "load_zero_i"});
  this->pulse({"tracer_reset_i", "copy_ext_i"});
  for (int n = 0; n < 40000; ++n) {
    const auto drive = [&](const char* name, int value) {
      this->pin(name).drive(value);
      return value;
    };
    const vec3 d = this->random_vector(11);
    this->delta(d);
    const bool reset = drive("tracer_reset_i", this->below(2));
    // camera_unit loads only while the tracer is in reset (contract 7.2, 7.4).
    const bool load = drive("load_i", reset && this->below(5) == 0);
    const bool load_zero = drive("load_zero_i", this->below(2));
    const bool ext = drive("ext_i", this->below(2));
    const int ext_sign = drive("ext_sign_i", this->below(8));
    const int mask = drive("axis_mask_i", this->below(8));
    const bool copy_ext = drive("copy_ext_i", this->below(2));
    const bool copy_sub = drive("copy_sub_i", this->below(2));
    const bool step = drive("step_i", this->below(2)), neg = drive("neg_i", this->below(2));
    const int log2 = this->below(10), idx2 = drive("idx2_i", this->below(1024));
    drive("step_size_i", 1 << log2);
    const vec3 old1 = dr1, old2 = dr2, moved = this->change(d, log2, neg, idx2);
    for (int a = 0; a < 3; ++a) {
      const bool in = mask >> a & 1, minus = ext_sign >> a & 1;
      if (load) dr2[a] = load_zero ? 0 : old1[a];
      else if (reset && ext) dr2[a] += in ? (minus ? -d[a] : d[a]) : 0;
      else if (step && (!reset || in)) dr2[a] += moved[a];
    }
    dr2 = this->wrapped(dr2);
    if (reset ? copy_ext : copy_sub) dr1 = old2;
    this->bench->clock();
    ASSERT_EQ(this->dr2(), dr2) << "clock " << n;
    ASSERT_EQ(this->dr1(), dr1) << "clock " << n;
  }
}

// Contract 8, rule 1: load has the highest priority; it does not ask for tracer_reset.
TYPED_TEST(RayStepperTest, LoadNeedsNoTracerReset) {
  this->put_dr2({100, -100, 7});
  this->pulse({"load_i", "load_zero_i"});
  EXPECT_EQ(this->dr2(), (vec3{0, 0, 0}));
}

TYPED_TEST(RayStepperTest, HoldsWhenNothingIsAsked) {
  this->put_dr2({1, -2, 3});
  this->delta({511, 300, -300});
  this->pulse({"copy_sub_i"});
  this->put_dr2({-4, 5, 511});
  this->pin("step_size_i").drive(64);
  this->pulse({"load_zero_i"});  // without load
  this->pulse({"ext_i"});        // without tracer_reset
  this->pulse({"copy_ext_i"});   // without tracer_reset
  this->pulse({"tracer_reset_i", "copy_sub_i"});
  this->bench->clock(100);
  EXPECT_EQ(this->dr1(), (vec3{1, -2, 3}));
  EXPECT_EQ(this->dr2(), (vec3{-4, 5, 511}));
}

}  // namespace
}  // namespace racebeam
