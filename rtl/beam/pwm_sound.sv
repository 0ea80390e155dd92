// pwm_sound: 24 voices of music, mixed one after the other, as one PWM pin.
// Contract: sc/beam/pwm_sound.h
//
// A voice is a multicycle path from slot, phase, frame and y to the accumulator: sound_voice.sdc.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module pwm_sound (
    // Clock and reset
    input wire logic clk_i,
    input wire logic rst_ni,
    // Pins of the chip
    /* verilator lint_off UNUSEDSIGNAL */  // bit 2 does not change the start value
    input wire logic [2:0] speed_i,  // bits 1:0 shift the start value
    /* verilator lint_on UNUSEDSIGNAL */
    output logic pwm_o,  // the sound; low for the length of the pulse
    // Time
    input wire logic signed [10:0] x2_i,  // half pixels, -960..639
    input wire logic signed [9:0] y_i,  // scan line, -273..251
    input wire logic [racebeam_pkg::FrameBits-1:0] frame_i
);
  localparam int VoiceBits = 10;
  localparam int SumBits = 15;
  localparam int PhaseBits = 19;
  localparam int HighBits = SumBits - VoiceBits;
  localparam logic [5:0] Voices = 6'd24;

  logic [10:0] pwm_q;  // counts up while bit 10 is 1, then holds
  logic [SumBits-1:0] sum_q;  // start value and voices so far
  logic [PhaseBits-1:0] phase_q;  // samples since reset
  logic carry_q;  // from the low to the high part of sum or phase
  logic negative_q;  // sign of the voice that is being added

  // --- Slot: 0..24 in sample A and again in sample B --------------------------------------------
  // Left and right of the line it is -1, -2 or from 25 up.
  wire logic sample_b = x2_i >= -11'sd160;
  wire logic [5:0] slot = x2_i[10:5] + (sample_b ? 6'd5 : 6'd30);
  wire logic [4:0] slot_clock = x2_i[4:0];
  wire logic is_voice = slot < Voices;
  wire logic is_end = slot == Voices;

  // --- The voice of this slot -------------------------------------------------------------------
  wire logic [10:0] sample = {10'(y_i - 10'(racebeam_pkg::FirstLine)), sample_b};
  wire logic signed [VoiceBits-1:0] value;
  sound_voice u_sound_voice (
      .taken_i(is_voice && slot_clock == 5'd29),
      .voice_i(slot[4:0]),
      .phase_i(phase_q),
      .frame_i(frame_i),
      .sample_i(sample),
      .value_o(value)
  );

  // --- Sum: the first voice starts from 16 * (24 * speed - 400), but for 4 bits that stay --------
  wire logic [10:0] start = 11'd24 * 11'(speed_i[1:0]) - 11'd400;
  wire logic [SumBits-1:0] from = slot == '0 ? {start, sum_q[3:0]} : sum_q;

  always_ff @(posedge clk_i) begin
    if (pwm_q[10]) pwm_q <= pwm_q + 11'd1;
    if (is_end && slot_clock == 5'd0) pwm_q <= sum_q[SumBits-1:4];
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      sum_q <= '0;
      phase_q <= '0;
      carry_q <= 1'b0;
      negative_q <= 1'b0;
    end else begin
      if (is_voice && slot_clock == 5'd29) begin
        {carry_q, sum_q[VoiceBits-1:0]} <= {1'b0, from[VoiceBits-1:0]} + {1'b0, value};
        negative_q <= value[VoiceBits-1];
      end
      if (is_voice && slot_clock == 5'd31)
        sum_q[SumBits-1:VoiceBits] <=
            from[SumBits-1:VoiceBits] + HighBits'(carry_q) - HighBits'(negative_q);
      if (is_end && slot_clock == 5'd0) {carry_q, phase_q[9:0]} <= 11'(phase_q[9:0]) + 11'd1;
      if (is_end && slot_clock == 5'd1) phase_q[18:10] <= phase_q[18:10] + 9'(carry_q);
    end
  end

  assign pwm_o = ~pwm_q[10];
endmodule

`default_nettype wire
