// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/sound_monitor.h"

#include <gtest/gtest.h>
#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "tb/base/output_file.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {
namespace {

constexpr double Pi = 3.14159265358979323846;
constexpr int Period = 800;  // clocks of a PWM period, as on the chip
constexpr double PwmRate = 50.4e6 / Period;

/// The chip's modulation of `sound`, a function of the time in s with values -1..1: low, then high.
void play(SoundMonitor& monitor, double seconds, const std::function<double(double)>& sound) {
  std::uint64_t clock = 0;
  for (; clock < seconds * 50.4e6; clock += Period) {
    const int low = static_cast<int>(std::lround(Period / 2 * (1 - sound(clock / 50.4e6))));
    if (low > 0) monitor.change(clock, false);
    if (low < Period) monitor.change(clock + low, true);
  }
  monitor.advance(clock);
}

std::vector<float> sine(double hertz, double amplitude, double offset = 0) {
  SoundMonitor monitor;
  play(monitor, 0.5, [&](double t) { return offset + amplitude * std::sin(2 * Pi * hertz * t); });
  return monitor.samples();
}

struct Fit {
  double amplitude, noise;  // noise: root of the mean square of what is no harmonic
};

/// Takes the first harmonics of `hertz` out of the middle of the sound (whole periods of 10 Hz).
Fit fit(std::vector<float> sound, double hertz, int harmonics) {
  sound.erase(sound.begin(), sound.begin() + 4800);
  sound.resize(sound.size() / 4800 * 4800 - 4800);
  double first = 0;
  for (int k = 1; k <= harmonics; ++k) {
    double re = 0, im = 0;
    const double turn = 2 * Pi * hertz * k / SoundMonitor::SampleRate;
    for (std::size_t i = 0; i < sound.size(); ++i) {
      re += sound[i] * std::cos(turn * i) * 2 / sound.size();
      im += sound[i] * std::sin(turn * i) * 2 / sound.size();
    }
    for (std::size_t i = 0; i < sound.size(); ++i)
      sound[i] -= static_cast<float>(re * std::cos(turn * i) + im * std::sin(turn * i));
    if (k == 1) first = std::hypot(re, im);
  }
  double sum = 0;
  for (const float s : sound) sum += double{s} * s;
  return {first, std::sqrt(sum / sound.size())};
}

float peak(const std::vector<float>& sound) {
  float most = 0;
  for (const float s : sound) most = std::max(most, std::abs(s));
  return most;
}

TEST(SoundMonitor, SineKeepsFrequencyAmplitudeAndPurity) {
  for (const double hertz : {50.0, 440.0, 1000.0, 5000.0}) {
    const Fit found = fit(sine(hertz, 0.5), hertz, 3);
    EXPECT_NEAR(found.amplitude, 0.5, 0.005) << hertz;
    const double ratio = 20 * std::log10(0.5 / std::sqrt(2) / found.noise);
    EXPECT_GT(ratio, 50) << hertz << " Hz; 800 steps allow 55 dB";
  }
}

TEST(SoundMonitor, CountIsTheTimeAt48kHz) {
  EXPECT_EQ(sine(1000, 0.5).size(), 24000u);
  SoundMonitor monitor;
  monitor.advance(1049);
  EXPECT_EQ(monitor.samples().size(), 0u);
  monitor.advance(1050);
  EXPECT_EQ(monitor.samples().size(), 1u);
}

TEST(SoundMonitor, PulseComesAtItsTimeAndSymmetric) {
  constexpr int Odd = 3155, Middle = (Odd * Period + 200) / 1050;  // a whole number of samples
  SoundMonitor monitor;
  std::uint64_t clock = 0;
  for (int period = 0; period < 2 * Odd; ++period, clock += Period) {
    monitor.change(clock, false);
    monitor.change(clock + (period == Odd ? 0 : 400), true);  // once without its low part
  }
  monitor.advance(clock);
  const std::vector<float> sound = monitor.samples();
  EXPECT_EQ(std::max_element(sound.begin(), sound.end()) - sound.begin(), Middle);
  EXPECT_NEAR(sound[Middle], 2 * 400 / 1050.0 * 21 / 24, 0.02);  // area times band
  for (int i = 1; i < 40; ++i) EXPECT_NEAR(sound[Middle - i], sound[Middle + i], 1e-3) << i;
}

TEST(SoundMonitor, IdlePwmIsSilentFromTheFirstSampleOn) {
  SoundMonitor monitor;
  monitor.change(0, true);
  std::uint64_t clock = 768;  // the chip's first sample
  for (; clock < 5'000'000; clock += Period) {
    monitor.change(clock, false);
    monitor.change(clock + 400, true);
  }
  monitor.advance(clock);
  EXPECT_LT(peak(monitor.samples()), 1e-3);
}

TEST(SoundMonitor, OffsetIsRemovedWithoutAClick) {
  for (const double offset : {-0.2, 0.1}) EXPECT_LT(peak(sine(1000, 0, offset)), 2e-3) << offset;
  EXPECT_NEAR(fit(sine(1000, 0.5, 0.2), 1000, 3).amplitude, 0.5, 0.005);
}

TEST(SoundMonitor, StuckPinIsSilent) {
  for (const bool level : {false, true}) {
    SoundMonitor monitor;
    monitor.change(0, level);
    monitor.advance(50'400'000);
    EXPECT_EQ(peak(monitor.samples()), 0);
  }
}

TEST(SoundMonitor, CarrierAndItsHarmonicsDoNotFoldIntoTheSound) {
  // Idle PWM has all odd multiples of its rate; the third is at 189 kHz, 3 kHz from 4 x 48 kHz.
  EXPECT_LT(fit(sine(1000, 0), 1000, 1).noise, 2e-5);
  EXPECT_GT(PwmRate, 48000);
}

TEST(SoundMonitor, LastChangeOfAClockWinsAndTimeOnlyGoesOn) {
  SoundMonitor clean, noisy;
  for (std::uint64_t clock = 0; clock < 1'000'000; clock += 500) {
    const bool level = clock / 500 % 3 == 0;
    clean.change(clock, level);
    noisy.change(clock, !level);
    noisy.change(clock, level);
  }
  EXPECT_EQ(clean.samples(), noisy.samples());
  EXPECT_THROW(clean.advance(10), std::logic_error);
}

TEST(SoundMonitor, OtherClockRatesKeepThePitch) {
  SoundMonitor monitor(10'000'000);                                // not a multiple of 48 kHz
  for (std::uint64_t clock = 0; clock < 5'000'000; clock += 5000)  // square wave of 1 kHz
    for (const int part : {0, 2500}) {
      if (clock == 0 && part == 0) monitor.change(0, true);
      monitor.change(clock + part, part == 0);
    }
  monitor.advance(5'000'000);
  EXPECT_EQ(monitor.samples().size(), 24000u);
  EXPECT_NEAR(fit(monitor.samples(), 2000, 9).amplitude, 4 / Pi, 0.01);
  EXPECT_THROW(SoundMonitor(1000), std::invalid_argument);
}

TEST(SoundMonitor, WavHoldsTheSamplesIn16Bits) {
  const ScratchFolder folder;
  SoundMonitor monitor;
  play(monitor, 0.1, [](double t) { return 0.5 * std::sin(2 * Pi * 440 * t); });
  monitor.write_wav(folder / "a.wav");
  EXPECT_EQ(folder.files(), 1);
  SF_INFO info{};
  SNDFILE* wav = sf_open((folder / "a.wav").c_str(), SFM_READ, &info);
  ASSERT_NE(wav, nullptr);
  std::vector<float> read(info.frames);
  sf_readf_float(wav, read.data(), info.frames);
  sf_close(wav);
  EXPECT_EQ(info.samplerate, 48000);
  EXPECT_EQ(info.channels, 1);
  EXPECT_EQ(info.format, SF_FORMAT_WAV | SF_FORMAT_PCM_16);
  const std::vector<float> sound = monitor.samples();
  ASSERT_EQ(read.size(), sound.size());
  for (std::size_t i = 0; i < sound.size(); ++i) ASSERT_NEAR(read[i], sound[i], 1.0 / 32767);
}

TEST(SoundMonitor, WavErrorsLeaveNoFile) {
  const ScratchFolder folder;
  SoundMonitor monitor;
  monitor.advance(50'400'000);
  EXPECT_THROW(monitor.write_wav(folder / "no/a.wav"), OutputError);
  const FileSizeLimit limit(10000);
  EXPECT_THROW(monitor.write_wav(folder / "a.wav"), OutputError);
  EXPECT_EQ(folder.files(), 0);
}

}  // namespace
}  // namespace racebeam
