// sound_voice: one of the 24 voices at one moment of the music.
// Contract: voice_value() in sc/beam/pwm_sound.h; the tune: sc/beam/tune.h.
//
// Combinational, with eight products one behind the other. In pwm_sound the inputs are stable from
// the first clock of a slot and the value is taken near its end, some 20 clocks later at the
// highest speed: sound_voice.sdc says so. All of it is functions: a simulator computes a voice only
// in the clock that takes it; in hardware taken_i is the last gate. Tones and drums share it: both
// are a sine; a tone's turns evenly and is modulated, a drum's slows down.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module sound_voice (
    input wire logic taken_i,  // value_o is wanted in this clock
    input wire logic [4:0] voice_i,  // 0..23
    input wire logic [18:0] phase_i,  // samples since reset
    input wire logic [13:0] frame_i,
    input wire logic [10:0] sample_i,  // in the frame, 0..1049
    output logic signed [9:0] value_o  // 0 if it is not wanted
);
  localparam logic [7:0] GoesOn = 8'hff;  // a step in which the note before goes on

  // Sustain and modulation of what is no tone
  localparam logic [40:0] NoTone = {11'd0, 2'd1, 11'd0, 5'd10, 11'd0, 1'b0};

  typedef enum logic [3:0] {
    Kick, Body, Snare, Hat, Crash, Tom, Bass, Lead, Second, Pad, Arpeggio
  } voice_kind;

  `include "tune_tables.svh"

  // --- What the voices are ----------------------------------------------------------------------
  // {kind, delay, detune, degree, octave, level}
  function automatic logic [23:0] setup(input logic [4:0] voice);
    case (voice)
      5'd0: setup = {Kick, 6'd0, 4'sd0, 3'd0, 1'd0, 6'd32};
      5'd1: setup = {Kick, 6'd0, 4'sd0, 3'd0, 1'd0, 6'd32};
      5'd2: setup = {Body, 6'd0, 4'sd0, 3'd0, 1'd0, 6'd20};
      5'd3: setup = {Snare, 6'd0, 4'sd0, 3'd0, 1'd0, 6'd27};
      5'd4: setup = {Hat, 6'd0, 4'sd0, 3'd0, 1'd0, 6'd18};
      5'd5: setup = {Crash, 6'd0, 4'sd0, 3'd0, 1'd0, 6'd18};
      5'd6: setup = {Tom, 6'd0, 4'sd0, 3'd0, 1'd0, 6'd26};
      5'd7: setup = {Bass, 6'd0, 4'sd0, 3'd0, 1'd0, 6'd30};
      5'd8: setup = {Bass, 6'd0, 4'sd1, 3'd0, 1'd1, 6'd16};
      5'd9: setup = {Lead, 6'd0, -4'sd1, 3'd0, 1'd0, 6'd30};
      5'd10: setup = {Lead, 6'd0, 4'sd4, 3'd0, 1'd0, 6'd12};
      5'd11: setup = {Lead, 6'd24, 4'sd0, 3'd0, 1'd0, 6'd11};
      5'd12: setup = {Lead, 6'd48, 4'sd0, 3'd0, 1'd0, 6'd6};
      5'd13: setup = {Second, 6'd0, 4'sd1, 3'd0, 1'd0, 6'd16};
      5'd14: setup = {Pad, 6'd0, 4'sd0, 3'd1, 1'd0, 6'd13};
      5'd15: setup = {Pad, 6'd0, 4'sd3, 3'd1, 1'd0, 6'd6};
      5'd16: setup = {Pad, 6'd0, 4'sd0, 3'd2, 1'd0, 6'd13};
      5'd17: setup = {Pad, 6'd0, -4'sd4, 3'd2, 1'd0, 6'd6};
      5'd18: setup = {Pad, 6'd0, 4'sd1, 3'd3, 1'd0, 6'd13};
      5'd19: setup = {Pad, 6'd0, -4'sd4, 3'd3, 1'd0, 6'd6};
      5'd20: setup = {Pad, 6'd0, -4'sd1, 3'd4, 1'd0, 6'd13};
      5'd21: setup = {Pad, 6'd0, 4'sd5, 3'd4, 1'd0, 6'd6};
      5'd22: setup = {Arpeggio, 6'd0, 4'sd0, 3'd0, 1'd1, 6'd18};
      5'd23: setup = {Arpeggio, 6'd24, 4'sd0, 3'd0, 1'd1, 6'd10};
      default: setup = '0;
    endcase
  endfunction

  // {attack, fade, decay, sustain, ratio, depth, depth_decay, depth_floor, vibrato}
  function automatic logic [53:0] sound(
      input logic [3:0] kind, input logic [1:0] accent, input logic [1:0] lead_sound,
      input logic [3:0] brightness);
    logic [4:0] hat_decay;
    logic [10:0] bright_depth;
    hat_decay = accent == 2'd3 ? 5'd12 : 5'd10;
    bright_depth = {1'b0, brightness, 6'd0};
    case (kind)
      Kick: sound = {4'd7, 4'd5, 5'd12, NoTone};
      Body: sound = {4'd7, 4'd5, 5'd11, NoTone};
      Snare: sound = {4'd8, 4'd5, 5'd11, NoTone};
      Hat: sound = {4'd8, 4'd5, hat_decay, NoTone};
      Crash: sound = {4'd8, 4'd5, 5'd14, NoTone};
      Tom: sound = {4'd6, 4'd5, 5'd12, NoTone};
      Bass: sound = {4'd5, 4'd4, 5'd14, 11'd560, 2'd1, 11'd1500, 5'd12, 11'd420, 1'b0};
      Pad: sound = {4'd2, 4'd3, 5'd18, 11'd1024, 2'd1, 11'd500, 5'd17, 11'd500, 1'b0};
      Arpeggio: sound = {4'd6, 4'd4, 5'd12, 11'd0, 2'd2, bright_depth, 5'd13, 11'd0, 1'b0};
      default:
      case (lead_sound)
        2'd0: sound = {4'd6, 4'd3, 5'd14, 11'd0, 2'd3, 11'd760, 5'd13, 11'd40, 1'b0};
        2'd1: sound = {4'd5, 4'd4, 5'd14, 11'd420, 2'd2, 11'd900, 5'd12, 11'd300, 1'b1};
        default: sound = {4'd5, 4'd4, 5'd15, 11'd640, 2'd1, 11'd1250, 5'd14, 11'd800, 1'b1};
      endcase
    endcase
  endfunction

  // --- Arithmetic -------------------------------------------------------------------------------
  // 1024, halving every 1 << shift samples, in straight pieces; ends at 0
  function automatic logic [10:0] decaying(input logic [17:0] n, input logic [4:0] shift);
    logic [9:0] fraction;
    fraction = 10'(n >> (shift - 5'd10));
    decaying = 11'((12'd2048 - 12'(fraction)) >> ((n >> shift) + 18'd1));
  endfunction

  // 0 at n = 0, full after 8192 >> speed samples
  function automatic logic [10:0] ramp(input logic [17:0] n, input logic [3:0] speed);
    logic [25:0] steep;
    steep = 26'(n) << speed >> 3;
    ramp = steep > 26'd1024 ? 11'd1024 : 11'(steep);
  endfunction

  function automatic logic [10:0] lesser(input logic [10:0] a, input logic [10:0] b);
    lesser = a < b ? a : b;
  endfunction

  // Two parabolas that look like a sine: -511..511, 4096 units a turn
  function automatic logic signed [9:0] sine(input logic [11:0] turn);
    logic [11:0] rest;
    logic [21:0] arc;
    logic [9:0] height;
    rest = 12'd2048 - 12'(turn[10:0]);
    arc = 22'(turn[10:0]) * 22'(rest) >> 11;
    height = arc > 22'd511 ? 10'd511 : 10'(arc);
    sine = turn[11] ? -height : height;
  endfunction

  // Noise without state: a hash of a sample number, -256..255
  function automatic logic signed [8:0] noise(input logic [18:0] n);
    logic [18:0] a;
    a = n * 19'h9e3b;
    a = (a ^ (a >> 8)) * 19'h6c4d;
    noise = 9'(a >> 7);
  endfunction

  // --- Where a note is in its bar ---------------------------------------------------------------
  // {note, step in which it began} of a bar in a step; the note is 0 for silence
  function automatic logic [11:0] note_in(input logic [127:0] steps, input logic [3:0] step);
    logic [7:0] text;
    note_in = '0;
    for (int i = 0; i < 16; i++) begin
      text = steps[8*(15-i)+:8];
      if (text != GoesOn && 4'(i) <= step) note_in = {text, 4'(i)};
    end
  endfunction

  // Steps of that note which follow
  function automatic logic [3:0] steps_left(input logic [127:0] steps, input logic [3:0] step);
    logic [3:0] last;
    last = 4'd15;
    for (int i = 15; i > 0; i--)
      if (steps[8*(15-i)+:8] != GoesOn && 4'(i) > step) last = 4'(i) - 4'd1;
    steps_left = last - step;
  endfunction

  function automatic logic [17:0] samples_of(input logic [3:0] whole_steps);
    samples_of = 18'(whole_steps) * 18'd8400;
  endfunction

  // --- Gain: 1024 is one ------------------------------------------------------------------------
  // Chords duck under the kick and come back; the gain has fallen before the kick begins.
  function automatic logic [10:0] ducked(
      input logic plays, input logic [17:0] since, input logic [17:0] left);
    logic [18:0] duck;
    duck = plays ? 19'(since) >> 4 : 19'd1024;
    if (19'(left) << 1 < duck) duck = 19'(left) << 1;
    ducked = duck < 19'd320 ? 11'd320 : duck > 19'd1024 ? 11'd1024 : 11'(duck);
  endfunction

  function automatic logic [10:0] strength_of(input logic [1:0] accent);
    case (accent)
      2'd0: strength_of = 11'd0;
      2'd1: strength_of = 11'd6 * 11'd64;
      2'd2: strength_of = 11'd11 * 11'd64;
      default: strength_of = 11'd16 * 11'd64;
    endcase
  endfunction

  // --- Pitch ------------------------------------------------------------------------------------
  // Phase increment of a note {octave, semitone}; 2^19 a turn
  function automatic logic [18:0] phase_increment(input logic [7:0] pitch);
    logic [17:0] scale;  // in octave 9
    logic [3:0] lower;  // octaves below it
    case (pitch[3:0])
      4'd0: scale = 18'd69672;
      4'd1: scale = 18'd73815;
      4'd2: scale = 18'd78204;
      4'd3: scale = 18'd82855;
      4'd4: scale = 18'd87781;
      4'd5: scale = 18'd93001;
      4'd6: scale = 18'd98531;
      4'd7: scale = 18'd104390;
      4'd8: scale = 18'd110598;
      4'd9: scale = 18'd117174;
      4'd10: scale = 18'd124142;
      default: scale = 18'd131524;
    endcase
    lower = 4'd9 - pitch[7:4];
    phase_increment = (19'(scale) + (19'd1 << lower >> 1)) >> lower;
  endfunction

  // --- Turn of the sine, 4096 is one ------------------------------------------------------------
  // A drum falls from high to low: an even turn less two parabolas that end after 4096 and 512
  // samples.
  /* verilator lint_off UNUSEDSIGNAL */  // products: bits above a turn and below a unit are dropped
  function automatic logic [11:0] falling(
      input logic [3:0] kind, input logic [1:0] accent, input logic [17:0] since);
    logic [10:0] base;
    logic [1:0] slow, fast;
    logic [12:0] to_4096;
    logic [9:0] to_512;
    logic [25:0] slow_bend;
    logic [18:0] fast_bend, turn;
    case (kind)
      Kick: {base, slow, fast} = {11'd400, 2'd2, 2'd3};
      Body: {base, slow, fast} = {11'd1500, 2'd2, 2'd2};
      default: {base, slow, fast} = {11'd450 + 11'd250 * 11'(accent), 2'd3, 2'd1};
    endcase
    to_4096 = since < 18'd4096 ? 13'd4096 - 13'(since) : '0;
    to_512 = since < 18'd512 ? 10'd512 - 10'(since) : '0;
    slow_bend = 26'(to_4096) * 26'(to_4096) >> 4;
    fast_bend = 19'(to_512) * 19'(to_512);
    turn =
        19'(base) * 19'(since) - 19'(slow) * 19'(slow_bend) - 19'(fast) * fast_bend +
        (19'(fast) << 18);
    falling = turn[18:7];
  endfunction

  function automatic logic [11:0] vibrato_bend(input logic [17:0] since);
    logic [17:0] late;
    logic [10:0] depth;
    logic [22:0] turn;
    logic signed [21:0] bend;
    late = since < 18'd12000 ? '0 : (since - 18'd12000) >> 4;
    depth = late > 18'd1024 ? 11'd1024 : 11'(late);
    turn = 23'(since) * 23'd23;
    bend = 22'(sine(turn[17:6])) * 22'(signed'({1'b0, depth}));
    vibrato_bend = bend[21:10];
  endfunction

  // --- Its value --------------------------------------------------------------------------------
  function automatic logic signed [9:0] value_of(
      input logic [4:0] voice, input logic [18:0] phase, input logic [13:0] now,
      input logic [10:0] sample);
    logic [3:0] kind;
    logic [5:0] delay;  // frames behind the tune: an echo
    logic signed [3:0] detune;  // added to the phase increment
    logic [2:0] degree;  // pads: note of the chord
    logic octave;  // notes are played this much higher
    logic [5:0] level;  // 0..32
    logic [13:0] frame;  // of the tune
    logic [2:0] harmony;
    logic [39:0] chord;
    logic [1:0] lead_sound;
    logic [3:0] brightness;
    logic [6:0] lead, second, pad, bass, arpeggio, kick, snare, hat, crash, tom, bar;
    logic [127:0] steps, kick_steps;
    logic [3:0] step;
    logic [13:0] in_step;  // samples since it began
    logic [7:0] note, kick_note, chord_note, pitch;
    logic [3:0] first, kick_first;  // steps in which they began
    logic [17:0] since, left;  // samples since the note began, and of it that follow
    logic is_drum;
    logic [3:0] attack;  // full gain after 8192 >> n samples
    logic [3:0] fade;  // and this long before the end
    logic [4:0] decay;  // gain halves in 1 << n samples
    logic [10:0] sustain;  // and does not fall below this
    logic [1:0] ratio;  // pitch of the modulating sine
    logic [10:0] depth;  // of the modulation, 652 is 1 radian
    logic [4:0] depth_decay;
    logic [10:0] depth_floor;
    logic vibrato;
    logic [10:0] swell, shape, strength, gain;
    logic [18:0] even;
    logic [11:0] turn, depth_now;
    logic [21:0] fallen_depth;
    logic signed [21:0] modulation;
    logic signed [8:0] hiss;
    logic signed [9:0] wave;
    logic signed [27:0] product;

    // Where the voice is in the tune. An echo of frame 0 asks for measure 127, which is silent.
    {kind, delay, detune, degree, octave, level} = setup(voice);
    frame = now - 14'(delay);
    {harmony, lead, lead_sound, second, pad, bass, arpeggio, kick, snare, hat, crash, tom,
     brightness} = measure_of(frame[13:7]);
    chord = chord_of(harmony);
    case (kind)
      Kick: bar = kick;
      Body, Snare: bar = snare;
      Hat: bar = hat;
      Crash: bar = crash;
      Tom: bar = tom;
      Bass: bar = bass;
      Lead: bar = lead;
      Second: bar = second;
      Pad: bar = pad;
      default: bar = arpeggio;
    endcase
    steps = steps_of(bar);
    kick_steps = steps_of(kick);
    step = frame[6:3];
    in_step = 14'(frame[2:0]) * 14'd1050 + 14'(sample);

    {note, first} = note_in(steps, step);
    since = samples_of(step - first) + 18'(in_step);
    left = samples_of(steps_left(steps, step)) + 18'd8399 - 18'(in_step);
    {attack, fade, decay, sustain, ratio, depth, depth_decay, depth_floor, vibrato} =
        sound(kind, note[1:0], lead_sound, brightness);
    is_drum = kind < Bass;

    // Gain: 1024 is one
    {kick_note, kick_first} = note_in(kick_steps, step);
    strength = is_drum ? strength_of(note[1:0]) : 11'd1024;
    if (kind == Pad)
      strength = ducked(
          kick_note != '0, samples_of(step - kick_first) + 18'(in_step),
          samples_of(steps_left(kick_steps, step)) + 18'd8399 - 18'(in_step));
    swell = decaying(since, decay);
    if (is_drum) swell = swell > 11'd512 ? 11'd1024 : swell << 1;
    if (swell < sustain) swell = sustain;
    shape = lesser(swell, lesser(ramp(since, attack), ramp(left, fade)));
    gain = 11'(22'(shape) * 22'(strength) >> 10);

    // Turn of the sine
    case (kind == Pad ? degree : note[2:0])
      3'd0: chord_note = chord[39:32];
      3'd1: chord_note = chord[31:24];
      3'd2: chord_note = chord[23:16];
      3'd3: chord_note = chord[15:8];
      default: chord_note = chord[7:0];
    endcase
    case (kind)
      Lead, Second: pitch = note;
      Pad: pitch = chord_note;
      default: pitch = chord_note + {note[7:4] - 4'd1 + 4'(octave), 4'd0};
    endcase
    even = (phase_increment(pitch) + 19'(detune)) * phase;
    turn = is_drum ? falling(kind, note[1:0], since) : even[18:7];
    if (vibrato) turn = turn + vibrato_bend(since);

    // Wave
    fallen_depth = 22'(depth) * 22'(decaying(since, depth_decay)) >> 10;
    depth_now = fallen_depth < 22'(depth_floor) ? 12'(depth_floor) : 12'(fallen_depth);
    modulation = 22'(sine(12'(ratio) * turn)) * 22'(signed'(depth_now));
    hiss = noise(19'(phase[18:1]));
    case (kind)
      Snare: wave = {hiss, 1'b1};
      Hat, Crash: wave = 10'(hiss) - 10'(noise(19'(phase[18:1]) - 19'd1));
      default: wave = sine(turn + modulation[20:9]);
    endcase

    // Rounded
    product = 28'(wave) * 28'(signed'({1'b0, gain})) * 28'(signed'({1'b0, level})) + 28'sd16384;
    value_of = note == '0 ? '0 : product[24:15];
  endfunction
  /* verilator lint_on UNUSEDSIGNAL */

  always_comb begin
    value_o = '0;
    if (taken_i) value_o = value_of(voice_i, phase_i, frame_i, sample_i);
  end
endmodule

`default_nettype wire
