// Promises of sc/beam/tune.h: in tune, in time, and music for the whole demo.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/tune.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "tests/beam/pwm_sound_bench.h"

namespace racebeam {
namespace {

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
