// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/monitor/sound_monitor.h"

#include <sndfile.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <stdexcept>

#include "tb/base/output_file.h"

namespace racebeam {
namespace {

constexpr double Pi = 3.14159265358979323846;
constexpr double CutOffHz = 21000;  // middle of the filter's slope
constexpr double KaiserBeta = 10;   // 100 dB
constexpr double CapacitorHz = 5;   // corner of the offset's removal
constexpr int ChargeSamples = SoundMonitor::SampleRate / 10;
constexpr int FadeSamples = SoundMonitor::SampleRate / 200;
constexpr int WavHeaderBytes = 44;

std::uint64_t checked_rate(std::uint64_t rate) {
  if (rate < 1'000'000 || rate > 1'000'000'000)
    throw std::invalid_argument("SoundMonitor: clock rate must be 1 MHz..1 GHz");
  return rate;
}

/// Removes the slow part, starting from a weighted mean of the first 100 ms.
void remove_offset(std::vector<float>& sound) {
  const std::size_t charge = std::min<std::size_t>(sound.size(), ChargeSamples);
  double offset = 0, weights = 0;
  for (std::size_t i = 0; i < charge; ++i) {
    const double weight = 1 - std::cos(2 * Pi * (i + 0.5) / charge);
    offset += weight * sound[i];
    weights += weight;
  }
  if (charge > 0) offset /= weights;
  const double pull = 1 - std::exp(-2 * Pi * CapacitorHz / SoundMonitor::SampleRate);
  for (float& sample : sound) {
    offset += pull * (sample - offset);
    sample = static_cast<float>(sample - offset);
  }
}

void fade_ends(std::vector<float>& sound) {
  const std::size_t length = std::min<std::size_t>(FadeSamples, sound.size() / 2);
  for (std::size_t i = 0; i < length; ++i) {
    const auto gain = static_cast<float>(0.5 - 0.5 * std::cos(Pi * i / length));
    sound[i] *= gain;
    sound[sound.size() - 1 - i] *= gain;
  }
}

}  // namespace

SoundMonitor::SoundMonitor(std::uint64_t clock_rate)
    : clock_rate_(checked_rate(clock_rate)),
      phases_(static_cast<int>((clock_rate + SampleRate - 1) / SampleRate)),
      kernels_(std::make_shared<const std::vector<double>>(make_kernels(phases_))) {}

/// A step at phase p adds Taps differences from the sample HalfWidth - 1 before it on.
std::vector<double> SoundMonitor::make_kernels(int phases) {
  // Step response of a Kaiser-windowed sinc, by the clock.
  const int length = 2 * HalfWidth * phases;
  std::vector<double> response(length + 1, 0.0);
  for (int i = 0; i < length; ++i) {
    const double x = (i + 0.5) / phases - HalfWidth;  // samples, never 0 or exactly at the end
    const double turn = 2 * CutOffHz / SampleRate * Pi * x;
    const double sinc = turn == 0 ? 1 : std::sin(turn) / turn;
    const double u = x / HalfWidth;
    response[i + 1] =
        response[i] + sinc * std::cyl_bessel_i(0.0, KaiserBeta * std::sqrt(1 - u * u));
  }
  const auto at = [&](int i) {
    return i <= 0 ? 0.0 : i >= length ? 1.0 : response[i] / response[length];
  };
  std::vector<double> kernels(static_cast<std::size_t>(phases) * Taps);
  for (int phase = 0; phase < phases; ++phase)
    for (int tap = 0; tap < Taps; ++tap) {
      const int i = (tap + 1) * phases - phase;  // sample tap - HalfWidth + 1 after the step's
      kernels[static_cast<std::size_t>(phase) * Taps + tap] = at(i) - at(i - phases);
    }
  return kernels;
}

void SoundMonitor::Sampler::run(std::uint64_t until, std::vector<float>& out) {
  for (; next < until; ++next) {
    double& difference = slope[next % Ring];
    level += difference;
    difference = 0;
    out.push_back(static_cast<float>(level));
  }
}

void SoundMonitor::Sampler::step(std::uint64_t sample, const double* kernel, double height,
                                 std::vector<float>& out) {
  constexpr std::uint64_t Before = HalfWidth - 1;
  if (sample > Before) run(sample - Before, out);
  for (int tap = 0; tap < Taps; ++tap) {
    // What belongs before sample 0 goes into it.
    const std::uint64_t to = std::max<std::uint64_t>(sample + tap, Before) - Before;
    slope[to % Ring] += height * kernel[tap];
  }
}

void SoundMonitor::step_at(Sampler& sampler, std::uint64_t clock, double height,
                           std::vector<float>& out) const {
  const std::uint64_t sample = clock * SampleRate / clock_rate_;
  const std::uint64_t rest = clock * SampleRate % clock_rate_;
  const std::size_t phase = rest * phases_ / clock_rate_;
  sampler.step(sample, kernels_->data() + phase * Taps, height, out);
}

/// The last change is final: it becomes a step.
void SoundMonitor::settle() {
  if (!told_ || pending_level_ == level_) return;
  level_ = pending_level_;
  step_at(sampler_, pending_clock_, (moving_ ? 2 : 1) * (level_ ? 1.0 : -1.0), raw_);
  moving_ = true;
}

void SoundMonitor::change(std::uint64_t clock, bool level) {
  advance(clock);
  if (!told_ || (!moving_ && clock == 0)) level_ = level;
  told_ = true;
  pending_clock_ = clock;
  pending_level_ = level;
}

void SoundMonitor::advance(std::uint64_t clock) {
  if (clock < now_) throw std::logic_error("SoundMonitor: the clock runs backwards");
  now_ = clock;
  if (clock > pending_clock_) settle();
}

std::vector<float> SoundMonitor::samples() const {
  const std::uint64_t count = now_ * SampleRate / clock_rate_;
  std::vector<float> sound = raw_;
  Sampler rest = sampler_;
  if (moving_) step_at(rest, now_, level_ ? -1.0 : 1.0, sound);  // back to half scale
  rest.run(count, sound);
  sound.resize(count);
  remove_offset(sound);
  fade_ends(sound);
  return sound;
}

void SoundMonitor::write_wav(const std::string& path) const {
  const std::vector<float> sound = samples();
  OutputFile file(path);
  SF_INFO info{};
  info.samplerate = SampleRate;
  info.channels = 1;
  info.format = SF_FORMAT_WAV | SF_FORMAT_PCM_16;
  errno = 0;
  SNDFILE* wav = sf_open(file.temporary_path().c_str(), SFM_WRITE, &info);
  if (!wav) throw OutputError(path, errno, sf_strerror(nullptr));
  sf_command(wav, SFC_SET_CLIPPING, nullptr, SF_TRUE);
  errno = 0;
  const auto count = static_cast<sf_count_t>(sound.size());
  bool good = sf_writef_float(wav, sound.data(), count) == count;
  const int error = errno;
  const std::string reason = sf_strerror(wav);
  good = sf_close(wav) == 0 && good;
  if (!good) throw OutputError(path, error, reason);
  file.commit(WavHeaderBytes + 2 * sound.size());
}

}  // namespace racebeam
