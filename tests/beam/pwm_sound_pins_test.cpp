// Promises of sc/beam/pwm_sound.h at the pins: what is heard, on both twins.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "sc/video/vga_timing.h"
#include "tb/twin/unit_bench.h"
#include "tests/beam/pwm_sound_bench.h"
#include "tests/support/own_rtl.h"

namespace racebeam {
namespace {

/// The unit at its pins, and the sums that it should put out, added up plainly.
template <class Unit>
class PwmSoundPins : public testing::Test {
 protected:
  Unit unit{"dut"};
  UnitBench bench{unit};
  int sum = 0, samples = 0;  // of the reference; `samples` since reset

  PwmSoundPins() { reset(); }
  void reset() {
    bench["rst_ni"].drive(0);
    bench.clock();
    bench["rst_ni"].drive(1);
    sum = samples = 0;
  }
  void clock(int x2) {
    bench["x2_i"].drive(x2);
    bench.clock();
  }
  /// The clocks of a sample in which something happens, the new sample last. `half`: 0 A, 1 B.
  void sample(int frame, int y, int half, int speed = 0) {
    bench["frame_i"].drive(frame);
    bench["y_i"].drive(y);
    bench["speed_i"].drive(speed);
    const int first = half ? -160 : -960;
    for (int voice = 0; voice < Voices; ++voice) {
      clock(first + 32 * voice + 29);
      clock(first + 32 * voice + 31);
    }
    add(frame, 2 * (y + 273) + half, speed);
    advance(1);
  }
  /// Slot 24 of sample A as often as that.
  void advance(int times) {
    for (; times > 0; --times, ++samples) {
      clock(-192);
      clock(-191);
    }
  }
  void add(int frame, int at, int speed) {
    sum = 16 * (24 * (speed & 3) - 400) + (sum & 15);
    for (int voice = 0; voice < Voices; ++voice)
      sum += voice_value(voice, samples & low_bits(PhaseBits), frame, at);
  }
  bool pin() { return bench["pwm_o"].value(); }
  /// Clocks that the pin is still low.
  int pulse() {
    int low = 0;
    for (; !pin(); ++low) clock(2);
    return low;
  }
};

using Twins = testing::Types<pwm_sound, own_rtl<pwm_sound>>;
TYPED_TEST_SUITE(PwmSoundPins, Twins);

TYPED_TEST(PwmSoundPins, PinIsHighUntilTheFirstSample) {
  for (int n = 0; n < 2000; ++n) {
    ASSERT_TRUE(this->pin());
    this->clock(2);
  }
}

// One clock of slot 24 has passed when the pulse begins.
TYPED_TEST(PwmSoundPins, PulsesAreTheSumsOfTheVoicesAllOverTheTune) {
  constexpr unsigned Seed = 16;
  SCOPED_TRACE(testing::Message() << "seed " << Seed);
  std::mt19937 random(Seed);
  for (int n = 0; n < 800; ++n) {
    const int frame = n * 16 + static_cast<int>(random() % 16);  // up to 12799
    const int y = static_cast<int>(random() % 525) - 273;
    this->sample(frame, y, n & 1);
    const int expected = -(this->sum >> 4);
    ASSERT_EQ(this->pulse() + 1, expected) << "frame " << frame << ", y " << y;
    this->advance(static_cast<int>(random() % 64));  // not heard: it puts the same sum out
    this->pulse();
  }
}

TYPED_TEST(PwmSoundPins, EveryNoteOfEveryTrackIsPlayed) {
  for (int step = 0; step < tune::Measures * tune::MeasureSteps; ++step) {
    const int frame = step * tune::StepFrames + step % tune::StepFrames;
    if (frame >= DemoFrames) break;
    this->sample(frame, step % 500 - 250, 0);
    ASSERT_EQ(this->pulse() + 1, -(this->sum >> 4)) << "frame " << frame;
  }
}

TYPED_TEST(PwmSoundPins, SpeedShortensThePulse) {
  for (int speed = 0; speed < 8; ++speed) {
    this->sample(12800, 0, 0, speed);  // after the tune: silence
    EXPECT_EQ(this->pulse() + 1, 400 - 24 * (speed & 3)) << "speed " << speed;
  }
}

// The clocks of whole lines, as vga_timing counts them.
TYPED_TEST(PwmSoundPins, LinesOfEverySpeedHoldTwoSamples) {
  constexpr int frame = 2200;
  const int clocks_per_pixel = knobs().clocks_per_pixel;
  vga_timing_core raster;
  this->bench["frame_i"].drive(frame);
  int clocks = 0, low = 0;  // since the last new sample
  for (int n = 0; n < 8 * 40; clocks = low = 0, ++n) {
    const int speed = n / 40;
    this->bench["speed_i"].drive(speed);
    vga_timing_core::outputs o;
    do {
      o = raster.comb({true, speed}, clocks_per_pixel);
      this->bench["y_i"].drive(o.y);
      low += !this->pin();
      ++clocks;
      this->clock(o.x2);
      raster.clock({true, speed}, clocks_per_pixel);
    } while (o.x2 != -192 && o.x2 != 608);
    if (n > 0) {
      ASSERT_EQ(low, std::min(-(this->sum >> 4), clocks)) << "speed " << speed << ", y " << o.y;
    }
    this->add(frame, 2 * (o.y + 273) + (o.x2 == 608), speed);
    ++this->samples;
  }
}

TYPED_TEST(PwmSoundPins, ResetStartsPhaseAndSumAnewAndLeavesThePulse) {
  for (int n = 0; n < 5; ++n) this->sample(2100, 7, 0);
  const int expected = -(this->sum >> 4);
  this->reset();
  EXPECT_EQ(this->pulse() + 2, expected) << "goes on";
  for (int n = 0; n < 5; ++n) this->sample(2101, 8, 1);
  EXPECT_EQ(this->pulse() + 1, -(this->sum >> 4));
}

}  // namespace
}  // namespace racebeam
