// Promises of sc/pwm_sound.h: the pin and its clocks, then the voices, then the tune.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/pwm_sound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <vector>

#include "sc/tune.h"
#include "sc/vga_timing.h"

namespace racebeam {
namespace {

constexpr int DemoSamples = DemoFrames * FrameSamples;
constexpr int StepSamples = tune::StepFrames * FrameSamples;

/// The core behind a raster, so that it sees the x2 of any speed.
struct Bench {
  const knobs k;
  vga_timing_core raster;
  pwm_sound_core core;
  int frame = 0, speed = 0;

  int x2() const { return raster.comb({true, speed}, k).x2; }
  /// One clock; returns the pin before it.
  bool clock() {
    const auto o = raster.comb({true, speed}, k);
    const bool pin = core.comb().pwm;
    core.clock({true, speed, o.x2, o.y, frame}, k);
    raster.clock({true, speed}, k);
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

int voice_sum(int n) {
  int sum = 0;
  for (int voice = 0; voice < Voices; ++voice)
    sum += voice_value(voice, n & low_bits(PhaseBits), n / FrameSamples, n % FrameSamples);
  return sum;
}

TEST(PwmSound, PulseOfMinus538IsLowFor538ClocksThenHighFor262) {
  Bench b;
  b.core.sum_q = (-538 * 16 + 7) & low_bits(SumBits);
  while (b.x2() != -192) b.raster.clock({true, 0}, b.k);
  b.core.clock({true, 0, -192, 0, 0}, b.k);
  for (int n = 0; n < 800; ++n) {
    ASSERT_EQ(b.core.comb().pwm, n >= 538) << "clock " << n;
    b.core.clock({true, 0, 2, 0, 0}, b.k);
  }
}

TEST(PwmSound, CounterHoldsAtZeroAndAtPositiveValues) {
  pwm_sound_core core;
  for (const int value : {0, 1, 1023}) {
    core.sum_q = value * 16;
    core.clock({true, 0, 608, 0, 0}, {});
    for (int n = 0; n < 2000; ++n) core.clock({true, 0, 2, 0, 0}, {});
    EXPECT_EQ(core.pwm_q, value);
    EXPECT_TRUE(core.comb().pwm);
  }
}

TEST(PwmSound, NewSampleIsTheFirstClockOfSlot24) {
  std::set<int> loads;
  for (int x2 = -960; x2 < 640; ++x2) {
    pwm_sound_core core;
    core.sum_q = 0x4000;
    core.clock({true, 0, x2, 0, 0}, {});
    if (core.pwm_q != 0) loads.insert(x2);
  }
  EXPECT_EQ(loads, (std::set<int>{-192, 608}));
}

TEST(PwmSound, PhaseAdvancesInClocks0And1OfSlot24) {
  pwm_sound_core core;
  core.phase_q = 5 << 10 | 1023;
  for (int x2 = -960; x2 < 640; ++x2) {
    core.clock({true, 0, x2, 0, 0}, {});
    const int expected = x2 < -192   ? 5 << 10 | 1023
                         : x2 < -191 ? 5 << 10
                         : x2 < 608  ? 6 << 10
                                     : 6 << 10 | 1;
    ASSERT_EQ(core.phase_q, expected) << "x2 " << x2;
  }
  core.phase_q = low_bits(PhaseBits);
  for (int x2 = -192; x2 < -160; ++x2) core.clock({true, 0, x2, 0, 0}, {});
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
    core.clock({true, 1, x2, y, frame}, {});
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
  core.clock({false, 0, -960, 0, 0}, {});
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
  pwm_sound unit("pwm_sound", {});
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
    const auto o = b.raster.comb({!reset, 0}, b.k);
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
    b.core.clock({!reset, 0, o.x2, o.y, b.frame}, b.k);
    edges += before != b.core.comb().pwm;
    b.raster.clock({!reset, 0}, b.k);
    ASSERT_EQ(pwm.read(), b.core.comb().pwm) << "clock " << n;
    ASSERT_EQ(unit.core().sum_q, b.core.sum_q) << "clock " << n;
  }
  EXPECT_GE(edges, 12);
}

// --- The voices -------------------------------------------------------------------------------

/// Which track a voice plays, and how many frames late.
struct Part {
  tune::bar_name tune::measure::*track;
  int delay;
};

Part part_of(int voice) {
  using m = tune::measure;
  if (voice < 2) return {&m::kick, 0};
  if (voice < 4) return {&m::snare, 0};
  if (voice == 4) return {&m::hat, 0};
  if (voice == 5) return {&m::crash, 0};
  if (voice == 6) return {&m::tom, 0};
  if (voice < 9) return {&m::bass, 0};
  if (voice < 13) return {&m::lead, voice < 11 ? 0 : voice == 11 ? 24 : 48};
  if (voice == 13) return {&m::second, 0};
  if (voice < 22) return {&m::pad, 0};
  return {&m::arpeggio, voice == 22 ? 0 : 24};
}

TEST(PwmSoundVoices, LimitsAddUpToWhatThePinCanShow) {
  int sum = 0;
  for (int voice = 0; voice < Voices; ++voice) sum += voice_limit(voice);
  EXPECT_LE(sum, MaximumSum);
  EXPECT_GT(sum, 6000) << "loudness given away";
}

TEST(PwmSoundVoices, NoVoiceExceedsItsLimitOrItsTenBits) {
  for (int voice = 0; voice < Voices; ++voice) {
    ASSERT_LE(voice_limit(voice), 511);
    for (int n = 0; n < DemoSamples; n += 13)
      ASSERT_LE(
          std::abs(voice_value(voice, n & low_bits(PhaseBits), n / FrameSamples, n % FrameSamples)),
          voice_limit(voice))
          << "voice " << voice << " sample " << n;
  }
}

TEST(PwmSoundVoices, EveryNoteBeginsAndEndsInSilence) {
  for (int voice = 0; voice < Voices; ++voice) {
    const Part part = part_of(voice);
    const auto value = [&](int n) {
      return voice_value(voice, n & low_bits(PhaseBits), n / FrameSamples, n % FrameSamples);
    };
    int notes = 0;
    for (int step = 0; step < tune::Measures * tune::MeasureSteps; ++step) {
      const auto& row = tune::arrangement[step / tune::MeasureSteps];
      const int word = tune::bars[row.*part.track][step % tune::MeasureSteps];
      const int n = step * StepSamples + part.delay * FrameSamples;
      if ((word >> 4 & 15) != 0 || n >= DemoSamples) continue;
      notes += word >> 8 != 0;
      EXPECT_EQ(value(n), 0) << "voice " << voice << " step " << step;
      if (n > 0) {
        EXPECT_EQ(value(n - 1), 0) << "voice " << voice << " step " << step;
      }
    }
    EXPECT_GT(notes, 0) << "voice " << voice << " never plays";
  }
}

TEST(PwmSoundVoices, NoToneEverJumps) {
  struct Tone {
    int voice, eighths;  // of its limit: the steepest slope of its wave
  };
  constexpr Tone tones[] = {{0, 1},  {2, 1},  {6, 1},  {7, 1},  {8, 2},  {9, 6},
                            {10, 6}, {12, 6}, {13, 6}, {14, 1}, {20, 1}, {22, 6}};
  for (const Tone& tone : tones) {
    const int largest = voice_limit(tone.voice) * tone.eighths / 8;
    int last = 0;
    for (int n = 0; n < DemoSamples; ++n) {
      const int value =
          voice_value(tone.voice, n & low_bits(PhaseBits), n / FrameSamples, n % FrameSamples);
      ASSERT_LE(std::abs(value - last), largest) << "voice " << tone.voice << " sample " << n;
      last = value;
    }
  }
}

TEST(PwmSoundVoices, TheDemoEndsInSilence) {
  for (int n = DemoSamples - 2 * FrameSamples; n < DemoSamples; ++n) ASSERT_EQ(voice_sum(n), 0);
}

TEST(PwmSoundVoices, APadTurnsAsOftenAsItsNoteSays) {
  int turns = 0;  // the first chord stands still; only the phase moves
  bool above = false;
  for (int phase = 0; phase <= low_bits(PhaseBits); ++phase) {
    const int value = voice_value(14, phase, 40, 0);
    turns += !above && value > 20;
    above = value > 20 || (above && value > -20);
  }
  EXPECT_NEAR(turns, phase_increment(tune::chords[tune::Dm][1]), 1);
}

// --- The tune ---------------------------------------------------------------------------------

double cents_wrong(int note) {
  const double exact = 440 * std::pow(2.0, (note >> 4) - 4 + ((note & 15) - 9) / 12.0);
  return 1200 * std::log2(phase_increment(note) * (63000.0 / (1 << 19)) / exact);
}

TEST(Tune, EveryNoteIsInTuneWithin3Cents) {
  EXPECT_EQ(phase_increment(0x49), 3662);
  for (const auto& row : tune::arrangement) {
    for (const int note : tune::chords[row.harmony]) EXPECT_LT(std::abs(cents_wrong(note)), 3);
    for (const auto track : {row.lead, row.second})
      for (const int word : tune::bars[track])
        if (word >> 8) {
          EXPECT_LT(std::abs(cents_wrong(word >> 8)), 3) << (word >> 8);
        }
  }
}

TEST(Tune, MelodyIsMadeOfTheChords) {
  int stressed = 0, stressed_in = 0, all = 0, all_in = 0;
  for (const auto& row : tune::arrangement)
    for (int step = 0; step < tune::MeasureSteps; ++step) {
      const int word = tune::bars[row.lead][step];
      if (word >> 8 == 0) continue;
      bool in_chord = false;
      for (const int note : tune::chords[row.harmony]) in_chord |= (note ^ word >> 8) % 16 == 0;
      ++all, all_in += in_chord;
      const bool begins = (word >> 4 & 15) == 0;
      if (begins && (step % 8 == 0 || (word & 15) >= 3)) ++stressed, stressed_in += in_chord;
    }
  EXPECT_GT(stressed, 150);
  EXPECT_GE(stressed_in * 100, stressed * 95);
  EXPECT_GE(all_in * 100, all * 80);
}

TEST(Tune, BeatsAre112AndAHalfAMinute) {
  EXPECT_EQ(60.0 * SampleRate / (4 * StepSamples), 112.5);
  for (int beat = 16 * 4; beat < 23 * 4; ++beat) {  // the groove: a kick on every beat
    const int n = beat * 4 * StepSamples;
    int before = 0, after = 0;
    for (int i = 1; i < 1000; ++i) {
      before = std::max(before, std::abs(voice_value(0, 0, (n - i) / 1050, (n - i) % 1050)));
      after = std::max(after, std::abs(voice_value(0, 0, (n + i) / 1050, (n + i) % 1050)));
    }
    EXPECT_LT(before, 60) << "beat " << beat;
    EXPECT_GT(after, 450) << "beat " << beat;
  }
}

TEST(Tune, NoPassageOfFourMeasuresTo60SecondsIsPlayedTwiceInARow) {
  const auto same = [](const tune::measure& a, const tune::measure& b) {
    return a.harmony == b.harmony && a.lead == b.lead && a.second == b.second && a.pad == b.pad &&
           a.bass == b.bass && a.arpeggio == b.arpeggio && a.kick == b.kick && a.snare == b.snare;
  };
  constexpr int minute = 29;  // measures of 2.1333 s
  for (int length = 4; length <= minute; ++length)
    for (int start = 0; start + 2 * length <= tune::Measures; ++start) {
      int equal = 0;
      for (int i = 0; i < length; ++i)
        equal += same(tune::arrangement[start + i], tune::arrangement[start + length + i]);
      EXPECT_LT(equal, length) << "measure " << start << ", length " << length;
    }
}

TEST(Tune, FourMeasuresAreNeitherLostNorMuchLouderThanOthersAndHaveNoDc) {
  constexpr int passage = 4 * tune::MeasureSteps * StepSamples;
  std::vector<double> loudness;
  for (int first = 0; first < DemoSamples; first += passage) {
    double sum = 0, squares = 0;
    int count = 0;
    for (int n = first; n < std::min(first + passage, DemoSamples); n += 11, ++count) {
      const double v = voice_sum(n);
      sum += v, squares += v * v;
    }
    EXPECT_LT(std::abs(sum / count), 16) << "measure " << first / passage * 4;
    loudness.push_back(10 * std::log10(squares / count) - 20 * std::log10(6400.0));
    EXPECT_GT(loudness.back(), -28) << "measure " << first / passage * 4;
    EXPECT_LT(loudness.back(), -18) << "measure " << first / passage * 4;
  }
  EXPECT_EQ(loudness.size(), 25u);
}

}  // namespace
}  // namespace racebeam
