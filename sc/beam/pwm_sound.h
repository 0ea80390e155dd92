// pwm_sound: 24 voices of music, mixed one after the other, as one PWM pin.
//
// What    A line has 50 slots of 32 clocks, slot = floor(x2 / 32) + 30: slots 0..24 make sample A,
//         25..49 sample B, 63,000 samples/s. In a sample each of slots 0..23 adds one voice to the
//         output accumulator; slot 24 puts the sum out and advances the phase. A sum of
//         -16 * n is n clocks low, then high until the next sample; the 4 bits that the pin cannot
//         show stay in the accumulator (first-order delta-sigma). A voice is a function of its
//         number, the phase and the musical time, so no voice has registers of its own.
//         Musical time is {frame, sample}, sample = 2 * (y + 273) + (sample B), 0..1049. It is
//         linear, other than the {frame, ty} of contract section 16, which is a fact of the
//         original's tune: ours counts samples from the start of each note.
// Size    47 register bits. A voice is 10 bits signed; the voices' largest values add up to 6400 at
//         most, so at speed 0 the sum stays in -12800..15 and cannot wrap.
// Cycles  Voice v of a sample is added in clocks 29 (low 10 bits) and 31 (the rest) of slot v. In
//         clock 0 of slot 24 (x2 = -192 and 608) the PWM counter loads the sum; pwm_o follows one
//         clock later. The phase advances in clocks 0 (low 10 bits) and 1 (high 9) of slot 24.
// Comb    none.
// Stall   none. Slot, frame_i and y_i hold from three clocks before clock 29 to clock 31 of a slot
//         (the last two change between lines): a voice is a path of four clocks, see
//         rtl/beam/sound_voice.sdc. The slot clocks 0, 1, 29, 31 occur at every speed.
// Reset   phase, accumulator and carry are 0; the PWM counter is not reset (0 at power-up: pin 1).
// Knobs   none; right only at the default clocks_per_pixel, 2, where x2 counts clocks.
// Twin    rtl/beam/pwm_sound.sv
// Test    tests/beam/pwm_sound_test.cpp
// Source  contract section 16 (interface). Voices and tune are our own.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "sc/base/constants.h"
#include "sc/base/probe.h"
#include "sc/base/unit.h"

namespace racebeam {

constexpr int Voices = 24;
constexpr int SampleRate = 63000;
constexpr int FrameSamples = 1050;
constexpr int PhaseBits = 19;
constexpr int SumBits = 15;           // 4 of them below the resolution of the pin
constexpr int VoiceBits = 10;         // signed
constexpr int MaximumSum = 400 * 16;  // largest |sum of voices| that fits a sample at speed 0

/// Value of one voice, -511..511: pure combinational logic and tables.
/// `phase` is the 19-bit sample count, `sample` the sample in the frame, 0..1049.
int voice_value(int voice, int phase, int frame, int sample);

/// No |voice_value| of this voice is larger.
int voice_limit(int voice);

/// Phase increment per sample, 2^19 a turn, of a note {octave(4), semitone(4)}; A4 = 440 Hz = 0x49.
int phase_increment(int note);

/// Behaviour of pwm_sound.
struct pwm_sound_core {
  int pwm_q = 0;            // 11 bits; counts up while bit 10 is 1, then holds
  int sum_q = 0;            // 15 bits: start value and voices so far
  int phase_q = 0;          // 19 bits: samples since reset
  bool carry_q = false;     // from the low to the high part of sum or phase
  bool negative_q = false;  // sign of the voice that is being added

  struct inputs {
    bool rst_n;
    int speed;
    int x2;  // signed
    int y;   // signed
    int frame;
  };
  struct outputs {
    bool pwm;
  };

  outputs comb() const { return {!bit_of(pwm_q, 10)}; }

  void clock(const inputs& in) {
    if (bit_of(pwm_q, 10)) pwm_q = (pwm_q + 1) & low_bits(11);
    if (is_busy(in.x2) || !in.rst_n) slot_clock(in);
  }

  /// So many clocks, none of them busy, at once.
  void hold(int clocks) {
    if (bit_of(pwm_q, 10)) pwm_q = std::min(pwm_q + clocks, 1 << 11) & low_bits(11);
  }
  /// Clocks until the pin is 1 if none of them is busy; 0 if it is.
  int rises_in() const { return bit_of(pwm_q, 10) ? (1 << 11) - pwm_q : 0; }

  /// Clocks 29 and 31 of every slot, 0 and 1 of slot 24; in all others only the pulse is counted.
  static bool is_busy(int x2) {
    return (x2 & 29) == 29 || ((x2 & 30) == 0 && slot_of(x2) == Voices);
  }
  /// 0..24 in sample A and again in sample B.
  static int slot_of(int x2) { return (x2 >> 5) + (in_sample_b(x2) ? 5 : 30); }
  static bool in_sample_b(int x2) { return x2 >= -160; }
  /// The clock in which the PWM counter takes the sum.
  static bool is_new_sample(int x2) { return x2 == -192 || x2 == 608; }
  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("pwm_q", 11, [this] { return pwm_q; });
    visit("sum_q", SumBits, [this] { return sum_q; });
    visit("phase_q", PhaseBits, [this] { return phase_q; });
    visit("carry_q", 1, [this] { return carry_q; });
    visit("negative_q", 1, [this] { return negative_q; });
  }

 private:
  void slot_clock(const inputs& in);
  void add_voice(const inputs& in, int voice);
};

/// Pins of pwm_sound.
class pwm_sound_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // Pins of the chip
  in_port<3> speed_i{"speed_i"};  // bits 1:0 shift the start value: shorter samples, shorter pulses
  out_port<1> pwm_o{"pwm_o"};     // the sound; low for the length of the pulse
  // Time
  in_port<11> x2_i{"x2_i"};        // signed, half pixels, -960..639
  in_port<10> y_i{"y_i"};          // signed, scan line, -273..251
  in_port<14> frame_i{"frame_i"};  // 0..12798

  explicit pwm_sound_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of pwm_sound: its core behind the pins.
class pwm_sound : public pwm_sound_pins, public probed {
 public:
  using pins = pwm_sound_pins;
  static constexpr const char* unit_name = "pwm_sound";

  explicit pwm_sound(const sc_core::sc_module_name& name);

  const pwm_sound_core& core() const { return core_; }
  std::vector<probe> probes() const override { return registers_of(core_); }

 private:
  void seq();
  void comb();

  pwm_sound_core core_;
};

}  // namespace racebeam
