// Promises of sc/beam/pwm_sound.h: the pin and its clocks.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/pwm_sound.h"

#include <gtest/gtest.h>

#include <set>

#include "sc/beam/knobs.h"
#include "sc/video/vga_timing.h"

namespace racebeam {
namespace {

/// The core behind a raster, so that it sees the x2 of any speed.
struct Bench {
  const int clocks_per_pixel = knobs().clocks_per_pixel;
  vga_timing_core raster;
  pwm_sound_core core;
  int frame = 0, speed = 0;

  int x2() const { return raster.comb({true, speed}, clocks_per_pixel).x2; }
  /// One clock; returns the pin before it.
  bool clock() {
    const auto o = raster.comb({true, speed}, clocks_per_pixel);
    const bool pin = core.comb().pwm;
    core.clock({true, speed, o.x2, o.y, frame});
    raster.clock({true, speed}, clocks_per_pixel);
    frame += o.frame_end;
    return pin;
  }
  /// Clocks until the next new sample has been loaded; returns how many it took.
  int to_new_sample() {
    for (int n = 1;; ++n) {
      const bool load = x2() == -192 || x2() == 608;
      clock();
      if (load) return n;
    }
  }
};

/// The sum of one sample, written down plainly.
int reference_sum(int previous, int speed, int phase, int frame, int sample) {
  int sum = (16 * (-400 + 24 * (speed & 3)) & ~15) + (previous & 15);
  for (int voice = 0; voice < 24; ++voice) sum += voice_value(voice, phase, frame, sample);
  return sum;
}

TEST(PwmSound, PulseOfMinus538IsLowFor538ClocksThenHighFor262) {
  Bench b;
  b.core.sum_q = (-538 * 16 + 7) & low_bits(SumBits);
  while (b.x2() != -192) b.raster.clock({true, 0}, b.clocks_per_pixel);
  b.core.clock({true, 0, -192, 0, 0});
  for (int n = 0; n < 800; ++n) {
    ASSERT_EQ(b.core.comb().pwm, n >= 538) << "clock " << n;
    b.core.clock({true, 0, 2, 0, 0});
  }
}

TEST(PwmSound, CounterHoldsAtZeroAndAtPositiveValues) {
  pwm_sound_core core;
  for (const int value : {0, 1, 1023}) {
    core.sum_q = value * 16;
    core.clock({true, 0, 608, 0, 0});
    for (int n = 0; n < 2000; ++n) core.clock({true, 0, 2, 0, 0});
    EXPECT_EQ(core.pwm_q, value);
    EXPECT_TRUE(core.comb().pwm);
  }
}

TEST(PwmSound, NewSampleIsTheFirstClockOfSlot24) {
  std::set<int> loads;
  for (int x2 = -960; x2 < 640; ++x2) {
    pwm_sound_core core;
    core.sum_q = 0x4000;
    core.clock({true, 0, x2, 0, 0});
    if (core.pwm_q != 0) loads.insert(x2);
  }
  EXPECT_EQ(loads, (std::set<int>{-192, 608}));
}

TEST(PwmSound, PhaseAdvancesInClocks0And1OfSlot24) {
  pwm_sound_core core;
  core.phase_q = 5 << 10 | 1023;
  for (int x2 = -960; x2 < 640; ++x2) {
    core.clock({true, 0, x2, 0, 0});
    const int expected = x2 < -192   ? 5 << 10 | 1023
                         : x2 < -191 ? 5 << 10
                         : x2 < 608  ? 6 << 10
                                     : 6 << 10 | 1;
    ASSERT_EQ(core.phase_q, expected) << "x2 " << x2;
  }
  core.phase_q = low_bits(PhaseBits);
  for (int x2 = -192; x2 < -160; ++x2) core.clock({true, 0, x2, 0, 0});
  EXPECT_EQ(core.phase_q, 0);
}

TEST(PwmSound, EachVoiceIsAddedInClocks29And31OfItsSlot) {
  constexpr int frame = 2100, y = -3;
  pwm_sound_core core;
  core.phase_q = 123456;
  core.sum_q = 0x2b5d;
  int sum = 0;
  for (int x2 = -960; x2 < -192; ++x2) {
    const int voice = (x2 + 960) / 32, clock = x2 & 31;
    const int before = core.sum_q;
    core.clock({true, 1, x2, y, frame});
    if (clock == 29) {
      if (voice == 0) sum = 16 * -376 + (0x2b5d & 15);
      sum += voice_value(voice, 123456, frame, 2 * (y + 273));
      ASSERT_EQ(core.sum_q & 1023, sum & 1023) << "voice " << voice;
      ASSERT_EQ(core.sum_q >> 10, before >> 10) << "voice " << voice;
    } else if (clock == 31) {
      ASSERT_EQ(core.sum_q, sum & 0x7fff) << "voice " << voice;
    } else {
      ASSERT_EQ(core.sum_q, before) << "x2 " << x2;
    }
  }
}

TEST(PwmSound, PulsesAreTheSumsWithTheirErrorsCarriedOver) {
  for (int speed = 0; speed < 4; ++speed) {
    Bench b;
    b.frame = 2200;
    b.speed = speed;
    b.to_new_sample();
    int sum = reference_sum(0, speed, 0, b.frame, 0);
    for (int n = 1; n < FrameSamples; ++n) {
      int low = 0;
      const int clocks = 800 - 50 * speed;
      for (int c = 0; c < clocks; ++c) low += !b.clock();
      ASSERT_EQ(low, -(sum >> 4)) << "speed " << speed << " sample " << n;
      sum = reference_sum(sum, speed, n, 2200, n);
      ASSERT_EQ(b.core.sum_q, sum & 0x7fff) << "speed " << speed << " sample " << n;
    }
  }
}

TEST(PwmSound, LowFourBitsAreCarriedIntoTheNextSample) {
  Bench b;  // frame 16000 is after the tune: all voices silent
  b.frame = 16000;
  b.core.sum_q = 11;
  for (int n = 0; n < 20; ++n) b.to_new_sample();
  EXPECT_EQ(wrap_signed(b.core.sum_q, SumBits), 16 * -400 + 11);
}

TEST(PwmSound, TwoSamplesALineOf800ClocksEach) {
  Bench b;
  EXPECT_EQ(b.to_new_sample(), 769);
  for (int n = 0; n < 1100; ++n) ASSERT_EQ(b.to_new_sample(), 800);
}

TEST(PwmSound, ResetClearsAllButThePulse) {
  pwm_sound_core core;
  core.sum_q = 0x5555;
  core.phase_q = 77777;
  core.carry_q = core.negative_q = true;
  core.pwm_q = 0x400;
  core.clock({false, 0, -960, 0, 0});
  EXPECT_EQ(core.sum_q, 0);
  EXPECT_EQ(core.phase_q, 0);
  EXPECT_FALSE(core.carry_q || core.negative_q);
  EXPECT_EQ(core.pwm_q, 0x401);
}

TEST(PwmSound, PinFollowsTheCoreClockByClock) {
  wire<1> clk, rst_n, pwm;
  wire<3> speed;
  wire<11> x2;
  wire<10> y;
  wire<14> frame;
  pwm_sound unit("pwm_sound");
  unit.clk_i(clk);
  unit.rst_ni(rst_n);
  unit.speed_i(speed);
  unit.pwm_o(pwm);
  unit.x2_i(x2);
  unit.y_i(y);
  unit.frame_i(frame);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  EXPECT_TRUE(pwm.read()) << "power-up";
  Bench b;
  b.frame = 2100;
  int edges = 0;
  for (int n = 0; n < 4 * 1600; ++n) {
    const bool reset = n < 3 || n == 3000;
    const auto o = b.raster.comb({!reset, 0}, b.clocks_per_pixel);
    rst_n.write(!reset);
    x2.write(o.x2 & low_bits(11));
    y.write(o.y & low_bits(10));
    frame.write(b.frame);
    clk.write(true);
    sc_core::sc_start(10, sc_core::SC_NS);
    clk.write(false);
    sc_core::sc_start(10, sc_core::SC_NS);
    // The pins took their values together with the edge, so the unit saw those of this clock.
    const bool before = b.core.comb().pwm;
    b.core.clock({!reset, 0, o.x2, o.y, b.frame});
    edges += before != b.core.comb().pwm;
    b.raster.clock({!reset, 0}, b.clocks_per_pixel);
    ASSERT_EQ(pwm.read(), b.core.comb().pwm) << "clock " << n;
    ASSERT_EQ(unit.core().sum_q, b.core.sum_q) << "clock " << n;
  }
  EXPECT_GE(edges, 12);
}

}  // namespace
}  // namespace racebeam
