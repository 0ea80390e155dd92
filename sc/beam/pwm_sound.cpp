// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/beam/pwm_sound.h"

#include <algorithm>

#include "sc/beam/tune.h"

namespace racebeam {

namespace {

constexpr int StepSamples = tune::StepFrames * FrameSamples;
constexpr int FullGain = 1024;

// --- What the 24 voices are -------------------------------------------------------------------

enum voice_kind { Kick, Body, Snare, Hat, Crash, Tom, Bass, Lead, Pad, Arpeggio };

struct voice_setup {
  voice_kind kind;
  tune::bar_name tune::measure::*track;
  int delay;   // frames behind the tune: an echo
  int detune;  // added to the phase increment
  int degree;  // pads: note of the chord
  int octave;  // notes are played this much higher
  int level;   // 0..32
};

using m = tune::measure;

// A second voice beside the first, detuned by 0.12 Hz a unit and softer, makes a tone wide. Two
// equal kicks are louder than the 10 bits of one voice.
constexpr voice_setup setups[Voices] = {
    {Kick, &m::kick, 0, 0, 0, 0, 32},         {Kick, &m::kick, 0, 0, 0, 0, 32},
    {Body, &m::snare, 0, 0, 0, 0, 20},        {Snare, &m::snare, 0, 0, 0, 0, 27},
    {Hat, &m::hat, 0, 0, 0, 0, 18},           {Crash, &m::crash, 0, 0, 0, 0, 18},
    {Tom, &m::tom, 0, 0, 0, 0, 26},           {Bass, &m::bass, 0, 0, 0, 0, 30},
    {Bass, &m::bass, 0, 1, 0, 1, 16},         {Lead, &m::lead, 0, -1, 0, 0, 30},
    {Lead, &m::lead, 0, 4, 0, 0, 12},         {Lead, &m::lead, 24, 0, 0, 0, 11},
    {Lead, &m::lead, 48, 0, 0, 0, 6},         {Lead, &m::second, 0, 1, 0, 0, 16},
    {Pad, &m::pad, 0, 0, 1, 0, 13},           {Pad, &m::pad, 0, 3, 1, 0, 6},
    {Pad, &m::pad, 0, 0, 2, 0, 13},           {Pad, &m::pad, 0, -4, 2, 0, 6},
    {Pad, &m::pad, 0, 1, 3, 0, 13},           {Pad, &m::pad, 0, -4, 3, 0, 6},
    {Pad, &m::pad, 0, -1, 4, 0, 13},          {Pad, &m::pad, 0, 5, 4, 0, 6},
    {Arpeggio, &m::arpeggio, 0, 0, 0, 1, 18}, {Arpeggio, &m::arpeggio, 24, 0, 0, 1, 10},
};

/// Sound of a pitched voice: a sine whose phase is modulated by a sine of `ratio` times its pitch.
struct instrument {
  int attack, release;  // full gain after 8192 >> n samples
  int decay;            // gain halves in 1 << n samples
  int sustain;          // and does not fall below this
  int ratio;
  int depth, depth_decay, depth_floor;  // 652 is 1 radian
  bool vibrato;
};

constexpr instrument lead_sounds[3] = {
    {6, 3, 14, 0, 3, 760, 13, 40, false},     // Bell
    {5, 4, 14, 420, 2, 900, 12, 300, true},   // Hollow
    {5, 4, 15, 640, 1, 1250, 14, 800, true},  // Bright
};
constexpr instrument pad_sound = {2, 3, 18, 1024, 1, 500, 17, 500, false};
constexpr instrument bass_sound = {5, 4, 14, 560, 1, 1500, 12, 420, false};
constexpr instrument arpeggio_sound = {6, 4, 12, 0, 2, 0, 13, 0, false};

// --- Arithmetic -------------------------------------------------------------------------------

/// Two parabolas that look like a sine: -511..511, 4096 units a turn.
int sine(int turn) {
  const int half = turn & 2047;
  const int arc = std::min(half * (2048 - half) >> 11, 511);
  return turn & 2048 ? -arc : arc;
}

/// 1024, halving every 1 << shift samples (shift > 9), in straight pieces; ends at 0.
int decaying(int n, int shift) {
  const int halvings = n >> shift;
  const int fraction = (n >> (shift - 10)) & 1023;
  return halvings > 10 ? 0 : (2048 - fraction) >> (halvings + 1);
}

/// 0 at n = 0, full after 8192 >> speed samples.
int ramp(int n, int speed) { return std::min(n << speed >> 3, FullGain); }

/// Noise without state: a hash of a sample number (19 bits), -256..255.
int noise(unsigned n) {
  n = n * 0x9e3b & 0x7ffff;
  return wrap_signed((n ^ n >> 8) * 0x6c4d >> 7 & 511, 9);
}

// --- Where a voice is in the tune -------------------------------------------------------------

struct moment {
  const tune::measure* measure;
  int note;  // 0: silence
  int n;     // samples since the note began
  int left;  // samples of the note that follow
};

moment at(const tune::bar_name tune::measure::*track, int frame, int sample) {
  const int number = frame / tune::MeasureFrames;
  if (frame < 0 || number >= tune::Measures) return {};
  const tune::measure& row = tune::arrangement[number];
  const int step = frame / tune::StepFrames % tune::MeasureSteps;
  const int word = tune::bars[row.*track][step];
  const int in_step = frame % tune::StepFrames * FrameSamples + sample;
  return {&row, word >> 8, (word >> 4 & 15) * StepSamples + in_step,
          (word & 15) * StepSamples + StepSamples - 1 - in_step};
}

/// Chords duck under the kick and come back; the gain has fallen before the kick begins.
int ducking(int frame, int sample) {
  const moment t = at(&tune::measure::kick, frame, sample);
  const int rising = t.note ? t.n >> 4 : FullGain;
  return std::clamp(std::min(rising, t.left << 1), 320, FullGain);
}

// --- The voices -------------------------------------------------------------------------------

/// A tone: -511..511 times its gain, in units of 1/1024.
int tone(const instrument& sound, const moment& t, int note, int detune, int phase, int gain,
         int extra_depth) {
  const unsigned step = static_cast<unsigned>(phase_increment(note) + detune);
  int turn = static_cast<int>(step * static_cast<unsigned>(phase) >> (PhaseBits - 12) & 4095);
  if (sound.vibrato) turn += sine(t.n * 23 >> 6) * std::clamp((t.n - 12000) >> 4, 0, 1024) >> 10;
  const int depth =
      std::max(sound.depth * decaying(t.n, sound.depth_decay) >> 10, sound.depth_floor) +
      extra_depth;
  const int wave = sine(turn + (sine(sound.ratio * turn) * depth >> 9));
  const int shape = std::min({std::max(decaying(t.n, sound.decay), sound.sustain),
                              ramp(t.n, sound.attack), ramp(t.left, sound.release)});
  return wave * (shape * gain >> 10);
}

/// Samples' worth of phase (2^19 a turn) of a tone that falls from high to low: `base` is the
/// final increment, the rest is two parabolas that end after 4096 and 512 samples.
int falling(int n, int base, int slow, int fast) {
  const int a = std::max(4096 - n, 0), b = std::max(512 - n, 0);
  const int whole = base * n - (slow * (a * a >> 4)) - fast * b * b;
  const int start = -(slow << 20) - (fast << 18);
  return (whole - start) >> (PhaseBits - 12);
}

int drum(voice_kind kind, const moment& t, int phase) {
  static constexpr int loudness[4] = {0, 6, 11, 16};
  const int accent = t.note & 3;
  const auto shape = [&](int decay, int attack) {
    const int gain =
        std::min({2 * decaying(t.n, decay), FullGain, ramp(t.n, attack), ramp(t.left, 5)});
    return gain * loudness[accent] >> 4;
  };
  switch (kind) {
    case Kick: return sine(falling(t.n, 400, 2, 3)) * shape(12, 7);
    case Body: return sine(falling(t.n, 1500, 2, 2)) * shape(11, 7);
    case Tom: return sine(falling(t.n, 450 + 250 * accent, 3, 1)) * shape(12, 6);
    case Snare: return (2 * noise(phase >> 1) + 1) * shape(11, 8);
    case Hat:
      return (noise(phase >> 1) - noise((phase >> 1) - 1)) * shape(accent == 3 ? 12 : 10, 8);
    default: return (noise(phase >> 1) - noise((phase >> 1) - 1)) * shape(14, 8);
  }
}

/// -511..511 times a gain in units of 1/1024.
int wave_times_gain(const voice_setup& v, const moment& t, int phase, int frame, int sample) {
  const int octaves = v.octave << 4;
  const auto& chord = tune::chords[t.measure->harmony];
  const auto degree_note = [&] { return chord[t.note & 15] + (t.note & 0xf0) - 16 + octaves; };
  switch (v.kind) {
    case Lead: return tone(lead_sounds[t.measure->sound], t, t.note, v.detune, phase, FullGain, 0);
    case Pad:
      return tone(pad_sound, t, chord[v.degree], v.detune, phase, ducking(frame, sample), 0);
    case Bass: return tone(bass_sound, t, degree_note(), v.detune, phase, FullGain, 0);
    case Arpeggio:
      return tone(arpeggio_sound, t, degree_note(), v.detune, phase, FullGain,
                  t.measure->brightness * decaying(t.n, 13) >> 4);
    default: return drum(v.kind, t, phase);
  }
}

}  // namespace

int voice_value(int voice, int phase, int frame, int sample) {
  const voice_setup& v = setups[voice];
  const moment t = at(v.track, frame - v.delay, sample);
  if (t.note == 0) return 0;
  return (wave_times_gain(v, t, phase, frame, sample) * v.level + (1 << 14)) >> 15;
}

int voice_limit(int voice) { return (511 * setups[voice].level + 16) >> 5; }

// The tempered scale of octave 9, shifted down and rounded: at most 3 cents wrong from G1 up.
int phase_increment(int note) {
  static constexpr int octave_9[12] = {69672, 73815,  78204,  82855,  87781,  93001,
                                       98531, 104390, 110598, 117174, 124142, 131524};
  const int shift = 9 - (note >> 4);
  return (octave_9[note & 15] + (1 << shift >> 1)) >> shift;
}

// --- The unit ---------------------------------------------------------------------------------

void pwm_sound_core::slot_clock(const inputs& in) {
  if (is_new_sample(in.x2)) pwm_q = sum_q >> 4;
  if (!in.rst_n) {
    const int pwm = pwm_q;
    *this = {};
    pwm_q = pwm;
    return;
  }
  const int slot = slot_of(in.x2);
  if (slot < 0 || slot > Voices) return;  // x2 is outside of the line
  if (slot < Voices) {
    add_voice(in, slot);
  } else if ((in.x2 & 31) == 0) {
    carry_q = (phase_q & low_bits(10)) == low_bits(10);
    phase_q = (phase_q & ~low_bits(10)) | ((phase_q + 1) & low_bits(10));
  } else if ((in.x2 & 31) == 1) {
    phase_q = (phase_q + (carry_q << 10)) & low_bits(PhaseBits);
  }
}

void pwm_sound_core::add_voice(const inputs& in, int voice) {
  const int start = 16 * 24 * (in.speed & 3) - MaximumSum;
  const int low = low_bits(VoiceBits);
  if ((in.x2 & 31) == 29) {
    const int value =
        voice_value(voice, phase_q, in.frame, 2 * (in.y - FirstLine) + in_sample_b(in.x2));
    const int from = voice == 0 ? (start & ~15) | (sum_q & 15) : sum_q;
    const int sum = (from & low) + (value & low);
    carry_q = sum > low;
    negative_q = value < 0;
    sum_q = (sum_q & ~low) | (sum & low);
  } else if ((in.x2 & 31) == 31) {
    const int from = voice == 0 ? start & ~low : sum_q & ~low;
    const int high = from + (carry_q << VoiceBits) - (negative_q << VoiceBits);
    sum_q = (high | (sum_q & low)) & low_bits(SumBits);
  }
}

pwm_sound::pwm_sound(const sc_core::sc_module_name& name) : pwm_sound_pins(name) {
  SC_HAS_PROCESS(pwm_sound);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(comb);  // once, for the level at power-up
}

void pwm_sound::seq() {
  core_.clock({rst_ni.value() != 0, speed_i.value(), x2_i.signed_value(), y_i.signed_value(),
               frame_i.value()});
  comb();
}

void pwm_sound::comb() { pwm_o.drive(core_.comb().pwm); }

}  // namespace racebeam
