// Promises of sc/beam/ray_stepper.h: its knobs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/beam/ray_stepper_bench.h"

namespace racebeam {
namespace {

TYPED_TEST_SUITE(RayStepperKnobTest, Twins);

// Knob dr_bits: the same rules, modulo 2^dr_bits; the ports carry the sign up to bit 12.
TYPED_TEST(RayStepperKnobTest, WalksAtDrBits8) {
  knobs k;
  k.dr_bits = 8;
  this->build(k);
  this->walk(150, true, this->without_fraction);
}

TYPED_TEST(RayStepperKnobTest, WalksAtDrBits11) {
  knobs k;
  k.dr_bits = 11;
  this->build(k);
  this->walk(150, true, this->without_fraction);
}

TYPED_TEST(RayStepperKnobTest, WalksAtDrBits13) {
  knobs k;
  k.dr_bits = 13;
  this->build(k);
  this->walk(150, true, this->without_fraction);
}

// Knob bisection = midpoint: any number of pixels in one clock, with the same results.
TYPED_TEST(RayStepperKnobTest, StepsOfAnySizeGiveTheSameDirections) {
  knobs k;
  k.bisection = BisectionMidpoint;
  this->build(k);
  this->walk(300, false, this->without_fraction);
}

// Knob stepping = fraction: dr2 is the rounded-down exact value at every pixel.
TYPED_TEST(RayStepperKnobTest, FractionStepsExactly) {
  knobs k;
  k.stepping = SteppingFraction;
  this->build(k);
  this->walk(300, true, [](int dr_0, int ddr, int i) { return dr_0 + floor_shift(ddr * i, 9); });
}

// Knob stepping_fraction_bits: the rule without fractions, in units of the last bit stored.
TYPED_TEST(RayStepperKnobTest, NoFractionBitsStoredIsTheJumper) {
  this->expect_stored(SteppingFraction, 0, true);
}
TYPED_TEST(RayStepperKnobTest, FourFractionBitsRoundTheOtherFive) {
  this->expect_stored(SteppingFraction, 4, true);
}
TYPED_TEST(RayStepperKnobTest, EightFractionBitsInDr2AloneRoundTheLast) {
  this->expect_stored(SteppingFractionDr2, 8, true);
}
TYPED_TEST(RayStepperKnobTest, StepsOfAnySizeKeepStoredFractions) {
  this->expect_stored(SteppingFractionDr2, 5, false);
}
TYPED_TEST(RayStepperKnobTest, NineFractionBitsAreExactForStepsOfAnySize) {
  this->expect_stored(SteppingFraction, 9, false);
}

TYPED_TEST(RayStepperKnobTest, FractionOfDr2AloneIsLostInTheCopy) {
  knobs k;
  k.stepping = SteppingFractionDr2;
  this->build(k);
  this->put_dr2({});
  this->delta({300, -1, 511});
  this->step(0, 1, false);  // 300/512, -1/512, 511/512
  this->pulse({"copy_sub_i"});
  this->step(1, 512, false);
  this->pulse({"tracer_reset_i", "load_i"});
  EXPECT_EQ(this->dr2(), (vec3{0, -1, 0}));
  this->step(1, 1, false);
  EXPECT_EQ(this->dr2(), (vec3{0, -2, 0})) << "-1 - 1/512";
}

TYPED_TEST(RayStepperKnobTest, FractionTravelsWithTheCopyAndTheLoad) {
  knobs k;
  k.stepping = SteppingFraction;
  this->build(k);
  this->put_dr2({});
  this->delta({300, -1, 511});
  this->step(0, 1, false);  // 300/512, -1/512, 511/512
  EXPECT_EQ(this->dr2(), (vec3{0, -1, 0}));
  this->pulse({"copy_sub_i"});
  this->step(1, 512, false);
  this->pulse({"tracer_reset_i", "load_i"});
  EXPECT_EQ(this->dr2(), (vec3{0, -1, 0}));
  this->step(1, 1, false);
  EXPECT_EQ(this->dr2(), (vec3{1, -1, 1}));
  this->step(2, 2, true);
  EXPECT_EQ(this->dr2(), (vec3{0, 0, 0}));
}

}  // namespace
}  // namespace racebeam
