// SoundMonitor: a loudspeaker on the PWM pin.
//
// The pin is fed as changes. It goes through one linear-phase low-pass (flat to 18 kHz, 100 dB down
// from 24 kHz on) at the full clock rate and is sampled at 48 kHz, mono; each change costs one
// kernel of 64 values. The offset is then removed as a coupling capacitor would, charged
// beforehand, with a fade of 5 ms at both ends, so that neither end clicks. Plain C++. Source:
// contract 16.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace racebeam {

class SoundMonitor {
 public:
  static constexpr int SampleRate = 48000;  ///< Hz

  /// `clock_rate` in Hz, 1 MHz..1 GHz; exact if a multiple of 48 kHz. Throws std::invalid_argument.
  explicit SoundMonitor(std::uint64_t clock_rate = 50'400'000);

  /// The pin has this level from `clock` on; of several calls for one clock the last wins. Until
  /// the level first changes the pin counts as half scale: a pin that never moves is silent.
  /// Throws std::logic_error if the clock runs backwards.
  void change(std::uint64_t clock, bool level);

  /// Every clock before `clock` is known. Throws as change() does.
  void advance(std::uint64_t clock);

  /// All sound so far, sample i at the time i / 48000 s after clock 0; 1 is a pin that is always
  /// high, -1 one that is always low.
  std::vector<float> samples() const;

  /// Writes samples() as a 16-bit mono WAV file. Throws OutputError.
  void write_wav(const std::string& path) const;

 private:
  static constexpr int HalfWidth = 31;            // samples
  static constexpr int Taps = 2 * HalfWidth + 2;  // samples that one change touches
  static constexpr int Ring = 128;                // power of two, more than Taps

  /// Turns steps of the pin's level into samples.
  struct Sampler {
    std::array<double, Ring> slope{};  // differences of samples still to come
    double level = 0;
    std::uint64_t next = 0;  // first sample that is still to come

    void step(std::uint64_t sample, const double* kernel, double height, std::vector<float>& out);
    void run(std::uint64_t until, std::vector<float>& out);
  };

  static std::vector<double> make_kernels(int phases);
  void settle();
  void step_at(Sampler& sampler, std::uint64_t clock, double height, std::vector<float>& out) const;

  const std::uint64_t clock_rate_;
  const int phases_;  // positions of a clock between two samples
  const std::shared_ptr<const std::vector<double>> kernels_;  // Taps differences for each phase
  Sampler sampler_;
  std::vector<float> raw_;
  std::uint64_t now_ = 0;            // every clock before is known
  std::uint64_t pending_clock_ = 0;  // of the last change, which may still be overwritten
  bool pending_level_ = false;
  bool told_ = false;    // change() was called
  bool level_ = false;   // before the last change
  bool moving_ = false;  // the level has changed at least once
};

}  // namespace racebeam
