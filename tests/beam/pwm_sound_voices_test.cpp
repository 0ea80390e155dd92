// Promises of sc/beam/pwm_sound.h: the voices.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/beam/pwm_sound_bench.h"

namespace racebeam {
namespace {

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

}  // namespace
}  // namespace racebeam
