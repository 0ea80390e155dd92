// The tune that pwm_sound plays: "Corners and Portals", D minor, 112.5 beats a minute, 100
// measures. Pure data, and the few functions that turn the written form into words.
//
// Time    A measure is 128 frames, a step (sixteenth) 8 frames, so the tune keeps the demo's parts
//         (16 measures each: intro, groove, tunnel, chorus, chase, break and last chorus, end).
// Bar     16 words, one per step: {note(8), age(4), left(4)}. `age` = steps since the note began,
//         `left` = steps of it that follow. Note 0 is silence. So a voice knows where it is within
//         its note from one look-up and needs no state.
// Note    melodies: {octave(4), semitone(4)}, C = 0, A4 = 440 Hz = 0x49.
//         chord patterns: {octaves up + 1 (4), degree(4)}; degree 0 is the bass, 1..4 the chord.
//         drums: 0x11..0x13, soft to loud.
// Written notes("D5 . F5 - ..."): a name starts a note, "." holds it, "-" is silence.
// steps("0.a-"):
//         a character per step; digit = degree or loudness, a..e = degree 0..4 an octave higher,
//         A..E two octaves higher.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace racebeam::tune {

constexpr int StepFrames = 8;
constexpr int MeasureSteps = 16;
constexpr int MeasureFrames = StepFrames * MeasureSteps;
constexpr int Measures = 100;

using bar = std::array<std::uint16_t, MeasureSteps>;

/// Fills in age and left where `started[step]` tells which steps begin a note or a silence.
constexpr bar with_ages(const std::array<int, MeasureSteps>& note,
                        const std::array<bool, MeasureSteps>& started) {
  bar words{};
  for (int step = 0; step < MeasureSteps; ++step) {
    int first = step, last = step;
    while (first > 0 && !started[first]) --first;
    while (last + 1 < MeasureSteps && !started[last + 1]) ++last;
    words[step] =
        static_cast<std::uint16_t>(note[first] << 8 | (step - first) << 4 | (last - step));
  }
  return words;
}

constexpr bar steps(const char* text) {
  std::array<int, MeasureSteps> note{};
  std::array<bool, MeasureSteps> started{};
  for (int step = 0; step < MeasureSteps; ++step) {
    const char c = text[step];
    started[step] = c != '.';
    if (c >= '0' && c <= '4') note[step] = 0x10 + (c - '0');
    if (c >= 'a' && c <= 'e') note[step] = 0x20 + (c - 'a');
    if (c >= 'A' && c <= 'E') note[step] = 0x30 + (c - 'A');
  }
  return with_ages(note, started);
}

/// {octave, semitone} of a name: letter, "#" or "b" or nothing, octave digit. Moves `text` on.
constexpr int note_of(const char*& text) {
  constexpr int semitones[7] = {9, 11, 0, 2, 4, 5, 7};
  int semitone = semitones[*text++ - 'A'];
  if (*text == '#') ++semitone, ++text;
  if (*text == 'b') --semitone, ++text;
  return (*text++ - '0') << 4 | semitone;
}

constexpr bar notes(const char* text) {
  std::array<int, MeasureSteps> note{};
  std::array<bool, MeasureSteps> started{};
  for (int step = 0; step < MeasureSteps; ++step) {
    while (*text == ' ') ++text;
    started[step] = *text != '.';
    if (*text == '.' || *text == '-') ++text;
    else note[step] = note_of(text);
  }
  return with_ages(note, started);
}

// --- Chords: bass note, then four chord notes -------------------------------------------------

enum chord_name : std::uint8_t { Dm, Bb, F, C, Gm, A7, Asus, Eb, Chords };

using chord = std::array<std::uint8_t, 5>;

constexpr std::array<chord, Chords> chords = {{
    {0x22, 0x39, 0x42, 0x45, 0x49},  // Dm:   D2, A3 D4 F4 A4
    {0x1a, 0x3a, 0x42, 0x45, 0x49},  // Bb:   Bb1, Bb3 D4 F4 A4
    {0x25, 0x39, 0x40, 0x45, 0x49},  // F:    F2, A3 C4 F4 A4
    {0x20, 0x37, 0x40, 0x44, 0x47},  // C:    C2, G3 C4 E4 G4
    {0x27, 0x37, 0x3a, 0x42, 0x47},  // Gm:   G2, G3 Bb3 D4 G4
    {0x19, 0x39, 0x41, 0x44, 0x47},  // A7:   A1, A3 C#4 E4 G4
    {0x19, 0x39, 0x42, 0x44, 0x49},  // Asus: A1, A3 D4 E4 A4
    {0x23, 0x37, 0x3a, 0x43, 0x47},  // Eb:   Eb2, G3 Bb3 Eb4 G4
}};

// --- Bars -------------------------------------------------------------------------------------

// clang-format off
enum bar_name : std::uint8_t {
  No,  // nothing to play
  // Melodies: opening, groove, tunnel, chorus (and its second voice), chase, break, end
  O1, O2, O3, O4, O5, O6, O7, O8,
  G1, G2, G3, G4, G5, G6, G7, G8, G9,
  T1, T2, T3, T4, T5, T6, T7, T8,
  H1, H2, H3, H4, H5, H6, H7, H8, HY, HZ,
  V1, V2, V3, V4, V5, V6, V7, V8, VY, VZ,
  S1, S2, S3, S4, S5, S6, S7, S8, S9, SA, SB, SC, SD, SE, SF, SG,
  Q1, Q2, Q3, Q4, Q5, Q6, Q7, Q8,
  E1, E2, E3,
  Pd, Pp, Ps, Pe,          // pads: long, two halves, stabs, last
  Bl, Bh, Bo, Br, Bg, Be,  // bass: long, halves, octaves, rolling, syncopated, last
  As, Au, Aw, A3, Ae,      // arpeggios: sparse, up, waves, in threes, last
  K1, K2, K4, KB, KF,      // kick: once, twice, four, broken, fill
  N2, NB, NR, NU,          // snare: 2 and 4, broken, fill, roll
  X4, X8, XG,              // hats: between beats, eighths, sixteenths
  Cr,                      // crash
  Tf, Tg,                  // toms
  Bars
};
// clang-format on

constexpr std::array<bar, Bars> make_bars() {
  std::array<bar, Bars> t{};
  t[No] = steps("-...............");
  // Opening: question in one measure, answer in the next.
  t[O1] = notes("- . . . . . . .  A4 . . . D5 . . .");
  t[O2] = notes("F5 . . . . . E5 .  D5 . . . . . . .");
  t[O3] = notes("- . . . . . . .  Bb4 . . . D5 . . .");
  t[O4] = notes("F5 . . . . . G5 .  F5 . . . D5 . . .");
  t[O5] = notes("- . . . . . . .  D5 . . . G5 . . .");
  t[O6] = notes("Bb5 . . . . . A5 .  G5 . . . . . . .");
  t[O7] = notes("A5 . . . . . G5 .  E5 . . . C#5 . . .");
  t[O8] = notes("E5 . . . . . . .  A5 . . . - . . .");
  // Groove: Dm Bb F C, Dm Bb Gm A7.
  t[G1] = notes("A4 . . D5 . . E5 .  F5 . . E5 . . D5 .");
  t[G2] = notes("D5 . . . . . F5 .  D5 . . C5 . . Bb4 .");
  t[G3] = notes("C5 . . F5 . . G5 .  A5 . . G5 . . F5 .");
  t[G4] = notes("G5 . . . . . E5 .  C5 . . D5 . . E5 .");
  t[G5] = notes("A4 . . D5 . . F5 .  A5 . . G5 . . F5 .");
  t[G6] = notes("F5 . . . D5 . . .  Bb5 . . A5 . . G5 .");
  t[G7] = notes("Bb5 . . A5 . . G5 .  D5 . . . G5 . . .");
  t[G8] = notes("A5 . . . G5 . . .  E5 . . . C#5 . . .");
  t[G9] = notes("E5 . . F5 . . E5 .  C#5 . . E5 . . A5 .");
  // Tunnel: short notes that leave room for their echoes. Gm Bb Dm Dm, Gm Bb C A7.
  t[T1] = notes("D5 - . G5 - . A5 .  Bb5 - . G5 . . - .");
  t[T2] = notes("F5 . . . . . - .  - . D5 . F5 . G5 .");
  t[T3] = notes("A5 - . F5 - . D5 .  F5 - . A5 . . - .");
  t[T4] = notes("D5 . . . . . - .  - . D5 . E5 . F5 .");
  t[T5] = notes("G5 - . Bb5 - . C6 .  D6 - . Bb5 . . - .");
  t[T6] = notes("Bb5 . . . . . - .  - . A5 . G5 . F5 .");
  t[T7] = notes("E5 - . G5 - . C6 .  Bb5 - . G5 . . - .");
  t[T8] = notes("A5 . . . . . - .  C#5 . E5 . G5 . A5 .");
  // Chorus: Bb C Dm F, Gm Bb C A7; second time it ends C Dm.
  t[H1] = notes("D5 . . . F5 . . .  Bb5 . . . . . A5 .");
  t[H2] = notes("G5 . . . . . E5 .  G5 . . . C6 . . .");
  t[H3] = notes("A5 . . . . . . .  F5 . . . G5 . A5 .");
  t[H4] = notes("C6 . . . . . A5 .  F5 . . . . . - .");
  t[H5] = notes("Bb5 . . . . . A5 .  G5 . . . D5 . . .");
  t[H6] = notes("F5 . . . . . G5 .  Bb5 . . . D6 . . .");
  t[H7] = notes("C6 . . . . . Bb5 .  G5 . . . E5 . . .");
  t[H8] = notes("E5 . . . . . . .  A5 . . . C#6 . . .");
  t[HY] = notes("C6 . . . . . D6 .  E6 . . . C6 . . .");
  t[HZ] = notes("D6 . . . . . . .  . . . . - . . .");
  // Second voice of the chorus: slower, a third to a sixth below.
  t[V1] = notes("Bb4 . . . D5 . . .  F5 . . . . . . .");
  t[V2] = notes("E5 . . . . . C5 .  E5 . . . G5 . . .");
  t[V3] = notes("F5 . . . . . . .  D5 . . . E5 . F5 .");
  t[V4] = notes("A5 . . . . . F5 .  C5 . . . . . - .");
  t[V5] = notes("G5 . . . . . F5 .  D5 . . . Bb4 . . .");
  t[V6] = notes("D5 . . . . . . .  F5 . . . Bb5 . . .");
  t[V7] = notes("G5 . . . . . . .  E5 . . . C5 . . .");
  t[V8] = notes("C#5 . . . . . . .  E5 . . . A5 . . .");
  t[VY] = notes("G5 . . . . . . .  C6 . . . G5 . . .");
  t[VZ] = notes("F5 . . . . . . .  A5 . . . - . . .");
  // Chase, two measures a chord as the scenes change: Dm C Bb A7, Gm F Eb A7.
  t[S1] = notes("D5 E5 F5 A5 . F5 . E5  D5 . A4 . D5 . E5 .");
  t[S2] = notes("F5 . E5 F5 . A5 . G5  F5 . E5 . D5 . - .");
  t[S3] = notes("C5 D5 E5 G5 . E5 . D5  C5 . G4 . C5 . D5 .");
  t[S4] = notes("E5 . D5 E5 . G5 . F5  E5 . D5 . C5 . - .");
  t[S5] = notes("Bb4 C5 D5 F5 . D5 . C5  Bb4 . F4 . Bb4 . C5 .");
  t[S6] = notes("D5 . C5 D5 . F5 . G5  F5 . D5 . F5 . - .");
  t[S7] = notes("E5 . C#5 E5 . A5 . G5  E5 . C#5 . E5 . G5 .");
  t[S8] = notes("A5 . . . G5 . . .  E5 . . . C#5 . . .");
  t[S9] = notes("Bb5 . A5 G5 . D5 . G5  Bb5 . A5 . G5 . D5 .");
  t[SA] = notes("G5 . A5 Bb5 . D6 . C6  Bb5 . A5 . G5 . - .");
  t[SB] = notes("A5 . G5 F5 . C5 . F5  A5 . G5 . F5 . C5 .");
  t[SC] = notes("F5 . G5 A5 . C6 . Bb5  A5 . G5 . F5 . - .");
  t[SD] = notes("G5 . F5 Eb5 . Bb4 . Eb5  G5 . F5 . Eb5 . Bb4 .");
  t[SE] = notes("Eb5 . F5 G5 . Bb5 . Ab5  G5 . F5 . Eb5 . - .");
  t[SF] = notes("E5 F5 E5 C#5 . E5 . A5  G5 . E5 . C#5 . E5 .");
  t[SG] = notes("A5 . . . . . . .  C#6 . . . E6 . . .");
  // Break: the chorus's harmony, half as many notes.
  t[Q1] = notes("F5 . . . . . . .  D5 . . . . . . .");
  t[Q2] = notes("E5 . . . . . . .  G5 . . . . . . .");
  t[Q3] = notes("A5 . . . . . . .  F5 . . . D5 . . .");
  t[Q4] = notes("C5 . . . . . . .  . . . . A4 . C5 .");
  t[Q5] = notes("D5 . . . . . . .  G5 . . . Bb5 . . .");
  t[Q6] = notes("Bb5 . . . . . . .  F5 . . . . . . .");
  t[Q7] = notes("G5 . . . E5 . . .  C5 . . . E5 . . .");
  t[Q8] = notes("A5 . . . . . . .  . . . . D6 . . .");
  // End: Bb C Dm, and a measure to ring out.
  t[E1] = notes("D6 . . . . . C6 .  Bb5 . . . F5 . . .");
  t[E2] = notes("E5 . . . G5 . . .  C6 . . . E6 . . .");
  t[E3] = notes("D6 . . . . . . .  . . . . . . . .");

  t[Pd] = steps("1...............");
  t[Pp] = steps("1.......1.......");
  t[Ps] = steps("1..1..1...1.1...");
  t[Pe] = steps("1.........-.....");
  t[Bl] = steps("0...............");
  t[Bh] = steps("0.......0...a...");
  t[Bo] = steps("0.a.0.a.0.a.0.a.");
  t[Br] = steps("-000-00a-000-0a0");
  t[Bg] = steps("0..0..a.-.0.a.0.");
  t[Be] = steps("0.......-.......");
  t[As] = steps("b..d..c.e..d..c.");
  t[Au] = steps("bcdebcdebcdebcde");
  t[Aw] = steps("bdecedcdbdecBedc");
  t[A3] = steps("bcebcebcbcebcece");
  t[Ae] = steps("b..c..d.e.-.....");

  t[K1] = steps("3...............");
  t[K2] = steps("3.........3.....");
  t[K4] = steps("3...3...3...3...");
  t[KB] = steps("3.....3...3.....");
  t[KF] = steps("3...3...3.3.3...");
  t[N2] = steps("-...3.......3...");
  t[NB] = steps("-...3..1.1..3..1");
  t[NR] = steps("-...3.......3223");
  t[NU] = steps("1.1.1.2.2.223333");
  t[X4] = steps("-.2.-.2.-.2.-.2.");
  t[X8] = steps("1.2.1.2.1.2.1.3.");
  t[XG] = steps("2121212321212123");
  t[Cr] = steps("3...............");
  t[Tf] = steps("-.......3.32.2.1");
  t[Tg] = steps("-.....3.....2.1.");
  return t;
}

inline constexpr std::array<bar, Bars> bars = make_bars();

// --- Arrangement ------------------------------------------------------------------------------

enum lead_sound : std::uint8_t { Bell, Hollow, Bright };

/// What each track plays in one measure.
struct measure {
  chord_name harmony;
  bar_name lead;
  lead_sound sound;
  bar_name second, pad, bass, arpeggio;
  bar_name kick, snare, hat, crash, tom;
  std::uint8_t brightness;  // 0..15, of the arpeggio
};

inline constexpr std::array<measure, Measures> arrangement = {{
    // harmony lead sound second pad bass arpeggio | kick snare hat crash tom | brightness
    // Part 0, pillars: the arpeggio comes out of the dark, drums one by one.
    {Dm, No, Bell, No, Pd, No, As, No, No, No, Cr, No, 0},
    {Dm, No, Bell, No, Pd, No, As, No, No, No, No, No, 1},
    {Bb, No, Bell, No, Pd, No, As, No, No, No, No, No, 2},
    {Bb, No, Bell, No, Pd, No, As, No, No, No, No, No, 3},
    {F, No, Bell, No, Pd, Bl, Au, No, No, No, No, No, 2},
    {F, No, Bell, No, Pd, Bl, Au, No, No, No, No, No, 3},
    {C, No, Bell, No, Pd, Bl, Au, No, No, No, No, No, 4},
    {C, No, Bell, No, Pd, Bl, Au, No, No, X4, No, No, 5},
    {Dm, O1, Bell, No, Pd, Bl, Au, K1, No, X4, Cr, No, 5},
    {Dm, O2, Bell, No, Pd, Bl, Au, K1, No, X4, No, No, 5},
    {Bb, O3, Bell, No, Pd, Bl, Au, K1, No, X4, No, No, 6},
    {Bb, O4, Bell, No, Pd, Bl, Au, K2, No, X4, No, No, 6},
    {Gm, O5, Bell, No, Pd, Bh, Au, K4, No, X4, No, No, 7},
    {Gm, O6, Bell, No, Pd, Bh, Au, K4, No, X4, No, No, 8},
    {A7, O7, Bell, No, Pd, Bh, Au, K4, No, X8, No, No, 9},
    {A7, O8, Bell, No, Pd, Bh, Au, K4, NU, X8, No, Tf, 11},
    // Part 1, lock patterns: the groove.
    {Dm, G1, Hollow, No, Ps, Bo, Aw, K4, N2, X4, Cr, No, 4},
    {Bb, G2, Hollow, No, Ps, Bo, Aw, K4, N2, X4, No, No, 4},
    {F, G3, Hollow, No, Ps, Bo, Aw, K4, N2, X4, No, No, 5},
    {C, G4, Hollow, No, Ps, Bo, Aw, K4, NR, X8, No, No, 5},
    {Dm, G5, Hollow, No, Ps, Bo, Aw, K4, N2, X4, No, No, 6},
    {Bb, G6, Hollow, No, Ps, Bo, Aw, K4, N2, X4, No, No, 6},
    {Gm, G7, Hollow, No, Ps, Bo, Aw, K4, N2, X8, No, No, 7},
    {A7, G8, Hollow, No, Ps, Bo, Aw, KF, NR, X8, No, Tg, 8},
    {Dm, G1, Bright, No, Ps, Bg, A3, K4, N2, X8, Cr, No, 6},
    {Bb, G2, Bright, No, Ps, Bg, A3, K4, N2, X8, No, No, 6},
    {F, G3, Bright, No, Ps, Bg, A3, K4, N2, X8, No, No, 7},
    {C, G4, Bright, No, Ps, Bg, A3, K4, NR, XG, No, No, 7},
    {Dm, G5, Bright, No, Ps, Bg, A3, K4, N2, X8, No, No, 8},
    {Bb, G6, Bright, No, Ps, Bg, A3, K4, N2, X8, No, No, 9},
    {Gm, G7, Bright, No, Ps, Bg, A3, K4, NB, XG, No, No, 10},
    {A7, G9, Bright, No, Pd, Bg, A3, K1, NU, XG, No, Tf, 12},
    // Part 2, tunnel: rolling bass, short notes and echoes.
    {Gm, No, Hollow, No, Pd, Br, No, K4, No, X4, Cr, No, 0},
    {Bb, No, Hollow, No, Pd, Br, No, K4, No, X4, No, No, 0},
    {Dm, No, Hollow, No, Pd, Br, As, K4, N2, X4, No, No, 2},
    {Dm, No, Hollow, No, Pd, Br, As, K4, N2, X4, No, Tg, 3},
    {Gm, T1, Hollow, No, Pd, Br, As, K4, N2, X4, No, No, 4},
    {Bb, T2, Hollow, No, Pd, Br, As, K4, N2, X4, No, No, 4},
    {Dm, T3, Hollow, No, Pd, Br, As, K4, N2, X4, No, No, 5},
    {Dm, T4, Hollow, No, Pd, Br, As, K4, NR, X8, No, No, 5},
    {Gm, T5, Hollow, No, Pd, Br, As, K4, N2, X8, Cr, No, 6},
    {Bb, T6, Hollow, No, Pd, Br, As, K4, N2, X8, No, No, 6},
    {C, T7, Hollow, No, Pd, Br, As, K4, N2, X8, No, No, 7},
    {A7, T8, Hollow, No, Pd, Br, As, K4, NR, X8, No, Tg, 7},
    {Gm, T1, Bell, No, Pd, Br, Au, K4, N2, XG, No, No, 8},
    {Bb, T2, Bell, No, Pd, Br, Au, K4, N2, XG, No, No, 9},
    {C, T7, Bell, No, Pd, Br, Au, K4, NB, XG, No, No, 10},
    {A7, T8, Bell, No, Pd, Br, Au, K1, NU, X8, No, Tf, 12},
    // Part 3, open heights: the chorus, twice.
    {Bb, H1, Bright, V1, Pp, Bo, Au, K4, N2, X4, Cr, No, 6},
    {C, H2, Bright, V2, Pp, Bo, Au, K4, N2, X4, No, No, 6},
    {Dm, H3, Bright, V3, Pp, Bo, Au, K4, N2, X4, No, No, 7},
    {F, H4, Bright, V4, Pp, Bo, Au, K4, NR, X8, No, No, 7},
    {Gm, H5, Bright, V5, Pp, Bo, Au, K4, N2, X4, No, No, 8},
    {Bb, H6, Bright, V6, Pp, Bo, Au, K4, N2, X4, No, No, 8},
    {C, H7, Bright, V7, Pp, Bo, Au, K4, N2, X8, No, No, 9},
    {A7, H8, Bright, V8, Pp, Bo, Au, KF, NR, X8, No, Tf, 9},
    {Bb, H1, Bright, V1, Pp, Br, Aw, K4, N2, XG, Cr, No, 8},
    {C, H2, Bright, V2, Pp, Br, Aw, K4, N2, XG, No, No, 8},
    {Dm, H3, Bright, V3, Pp, Br, Aw, K4, N2, XG, No, No, 9},
    {F, H4, Bright, V4, Pp, Br, Aw, K4, NB, XG, No, No, 9},
    {Gm, H5, Bright, V5, Pp, Br, Aw, K4, N2, XG, No, No, 10},
    {Bb, H6, Bright, V6, Pp, Br, Aw, K4, N2, XG, No, No, 10},
    {C, HY, Bright, VY, Pp, Br, Aw, K4, NB, XG, No, No, 11},
    {Dm, HZ, Bright, VZ, Pp, Bh, Aw, K2, NU, X8, No, Tf, 12},
    // Part 4, a scene every two measures: the chase, with a broken beat.
    {Dm, S1, Hollow, No, Ps, Bg, Aw, KB, NB, X8, Cr, No, 5},
    {Dm, S2, Hollow, No, Ps, Bg, Aw, KB, NB, X8, No, No, 6},
    {C, S3, Hollow, No, Ps, Bg, Aw, KB, NB, X8, Cr, No, 6},
    {C, S4, Hollow, No, Ps, Bg, Aw, KB, NB, X8, No, Tg, 7},
    {Bb, S5, Hollow, No, Ps, Bg, Aw, KB, NB, X8, Cr, No, 7},
    {Bb, S6, Hollow, No, Ps, Bg, Aw, KB, NB, X8, No, No, 8},
    {A7, S7, Hollow, No, Ps, Bg, Aw, KB, NB, X8, Cr, No, 8},
    {A7, S8, Hollow, No, Ps, Bg, Aw, KF, NR, XG, No, Tf, 9},
    {Gm, S9, Bright, No, Ps, Bo, A3, KB, NB, XG, Cr, No, 8},
    {Gm, SA, Bright, No, Ps, Bo, A3, KB, NB, XG, No, No, 9},
    {F, SB, Bright, No, Ps, Bo, A3, KB, NB, XG, Cr, No, 9},
    {F, SC, Bright, No, Ps, Bo, A3, KB, NB, XG, No, Tg, 10},
    {Eb, SD, Bright, No, Ps, Bo, A3, KB, NB, XG, Cr, No, 10},
    {Eb, SE, Bright, No, Ps, Bo, A3, KB, NB, XG, No, No, 11},
    {A7, SF, Bright, No, Pd, Bo, A3, K4, NB, XG, Cr, No, 11},
    {A7, SG, Bright, No, Pd, Bl, A3, K1, NU, XG, No, Tf, 12},
    // Part 5, portals: breath, then the last chorus.
    {Bb, Q1, Bell, No, Pd, Bl, As, No, No, No, Cr, No, 2},
    {C, Q2, Bell, No, Pd, Bl, As, No, No, No, No, No, 2},
    {Dm, Q3, Bell, No, Pd, Bl, As, No, No, No, No, No, 3},
    {F, Q4, Bell, No, Pd, Bl, As, No, No, X4, No, No, 3},
    {Gm, Q5, Bell, V5, Pd, Bl, Au, K1, No, X4, No, No, 4},
    {Bb, Q6, Bell, V6, Pd, Bl, Au, K1, No, X4, No, No, 6},
    {C, Q7, Bell, V7, Pd, Bh, Au, K4, No, X8, No, No, 8},
    {Asus, Q8, Bell, No, Pd, Bh, Au, K4, NU, X8, No, Tf, 10},
    {Bb, H1, Bright, V1, Ps, Br, Aw, K4, N2, XG, Cr, No, 9},
    {C, H2, Bright, V2, Ps, Br, Aw, K4, N2, XG, No, No, 9},
    {Dm, H3, Bright, V3, Ps, Br, Aw, K4, N2, XG, No, No, 10},
    {F, H4, Bright, V4, Ps, Br, Aw, K4, NB, XG, No, Tg, 10},
    {Gm, H5, Bright, V5, Ps, Br, Aw, K4, N2, XG, Cr, No, 11},
    {Bb, H6, Bright, V6, Ps, Br, Aw, K4, N2, XG, No, No, 11},
    {C, HY, Bright, VY, Ps, Br, Aw, K4, NB, XG, No, No, 12},
    {A7, H8, Bright, V8, Ps, Bo, Aw, KF, NR, XG, No, Tf, 12},
    // Part 6, last tunnel: four measures home.
    {Bb, E1, Bright, V1, Pp, Bo, Au, K4, N2, X8, Cr, No, 9},
    {C, E2, Bright, VY, Pp, Bo, Au, K4, NR, X8, No, Tf, 7},
    {Dm, E3, Bell, VZ, Pd, Bl, As, K1, No, X4, Cr, No, 4},
    {Dm, No, Bell, No, Pe, Be, Ae, K1, No, No, No, No, 1},
}};

}  // namespace racebeam::tune
