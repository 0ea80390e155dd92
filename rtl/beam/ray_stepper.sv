// ray_stepper: the ray directions at both ends of the interval, moved without a multiplier.
// The three axes are alike: one adder each, for the camera's sums and for steps.
// Contract: sc/beam/ray_stepper.h
//
// A register word is {direction, fraction}; the fraction has SteppingFractionBits in dr2 unless
// Stepping = 0, and in dr1 with Stepping = 1. step_size_i has one bit set, but for Bisection = 1:
// then any, and each bit is a step of its own from where the bits above it lead.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ray_stepper #(
    parameter int DrBits = 10,
    parameter int Bisection = 0,  // 0, 2: powers of two, 1: midpoints
    parameter int Stepping = 0,  // 0: without stored fractions, 1: with, 2: in dr2 alone
    parameter int SteppingFractionBits = 9
) (
    // Clock; phase of the line
    input  wire logic clk_i,
    input  wire logic tracer_reset_i,
    // camera_unit
    input  wire logic load_i,
    input  wire logic load_zero_i,
    input  wire logic ext_i,
    input  wire logic [2:0] ext_sign_i,
    input  wire logic [2:0] axis_mask_i,
    /* verilator lint_off UNUSEDSIGNAL */  // upper bits: for the widest DrBits only
    input  wire logic signed [racebeam_pkg::DdrPortBits-1:0] delta_x_i,
    input  wire logic signed [racebeam_pkg::DdrPortBits-1:0] delta_y_i,
    input  wire logic signed [racebeam_pkg::DdrPortBits-1:0] delta_z_i,
    /* verilator lint_on UNUSEDSIGNAL */
    input  wire logic copy_ext_i,
    // subdivider
    input  wire logic step_i,
    input  wire logic neg_i,
    input  wire logic [10:0] step_size_i,
    /* verilator lint_off UNUSEDSIGNAL */  // with stored fractions
    input  wire logic [racebeam_pkg::PixelBits-1:0] idx2_i,
    /* verilator lint_on UNUSEDSIGNAL */
    input  wire logic copy_sub_i,
    // Ray directions
    output logic signed [racebeam_pkg::DrPortBits-1:0] dr1_x_o,
    output logic signed [racebeam_pkg::DrPortBits-1:0] dr1_y_o,
    output logic signed [racebeam_pkg::DrPortBits-1:0] dr1_z_o,
    output logic signed [racebeam_pkg::DrPortBits-1:0] dr2_x_o,
    output logic signed [racebeam_pkg::DrPortBits-1:0] dr2_y_o,
    output logic signed [racebeam_pkg::DrPortBits-1:0] dr2_z_o
);
  localparam int PixelBits = racebeam_pkg::PixelBits;
  localparam int FractionBits = racebeam_pkg::DdrFractionBits;
  localparam int Fraction1 = Stepping == 1 ? SteppingFractionBits : 0;  // bits stored
  localparam int Fraction2 = Stepping != 0 ? SteppingFractionBits : 0;
  localparam int Dropped = FractionBits - Fraction2;
  localparam int Word1Bits = DrBits + Fraction1;
  localparam int WordBits = DrBits + Fraction2;
  localparam int DeltaBits = DrBits + 1;
  localparam int ProductBits = DeltaBits + 11;
  localparam int Steps = Bisection == 1 ? 11 : 1;  // in a clock

  logic copy;
  assign copy = tracer_reset_i ? copy_ext_i : copy_sub_i;

  // The lowest bit of idx2 that changes in a step of `size` pixels, a power of two, as one hot bit:
  // idx2 is 0 (1 to the left) there. None changes in a step that wraps: then bit 0 is taken.
  function automatic logic [PixelBits-1:0] change_bit(
      logic [PixelBits-1:0] idx2, logic neg, logic [PixelBits-1:0] size
  );
    logic [PixelBits-1:0] word;
    word = (neg ? idx2 : ~idx2) & -size;
    change_bit = word == '0 ? PixelBits'(1) : word & -word;
  endfunction

  // Of all steps of the clock, that of 1 lowest; a change of bit 9 adds nothing.
  /* verilator lint_off UNUSEDSIGNAL */  // with stored fractions
  logic [Steps*FractionBits-1:0] changes;
  /* verilator lint_on UNUSEDSIGNAL */
  always_comb begin
    logic [PixelBits-1:0] idx2, size;
    idx2 = idx2_i;
    for (int n = Steps - 1; n >= 0; n--) begin
      size = Bisection == 1 ? PixelBits'(step_size_i & 11'(1 << n)) : step_size_i[PixelBits-1:0];
      changes[n*FractionBits +: FractionBits] = FractionBits'(change_bit(idx2, neg_i, size));
      idx2 = neg_i ? idx2 - size : idx2 + size;
    end
  end

  for (genvar a = 0; a < 3; a++) begin : g_axis
    logic [Word1Bits-1:0] dr1_q;
    logic [WordBits-1:0] dr2_q, dr2_d;
    logic signed [DeltaBits-1:0] delta;
    logic [WordBits-1:0] move;  // of a step to the right

    if (a == 0) begin : g_x
      assign delta = delta_x_i[DeltaBits-1:0];
      assign dr1_x_o = racebeam_pkg::DrPortBits'($signed(dr1_q[Word1Bits-1:Fraction1]));
      assign dr2_x_o = racebeam_pkg::DrPortBits'($signed(dr2_q[WordBits-1:Fraction2]));
    end else if (a == 1) begin : g_y
      assign delta = delta_y_i[DeltaBits-1:0];
      assign dr1_y_o = racebeam_pkg::DrPortBits'($signed(dr1_q[Word1Bits-1:Fraction1]));
      assign dr2_y_o = racebeam_pkg::DrPortBits'($signed(dr2_q[WordBits-1:Fraction2]));
    end else begin : g_z
      assign delta = delta_z_i[DeltaBits-1:0];
      assign dr1_z_o = racebeam_pkg::DrPortBits'($signed(dr1_q[Word1Bits-1:Fraction1]));
      assign dr2_z_o = racebeam_pkg::DrPortBits'($signed(dr2_q[WordBits-1:Fraction2]));
    end

    // delta * size: what is stored, and one bit of delta that makes good for the fractions that are
    // dropped. With 9 of them dropped, bit 8 - b of delta goes with the change of bit b of idx2.
    always_comb begin
      logic [ProductBits-1:0] product;
      logic extra;
      move = '0;
      for (int s = 0; s < Steps; s++) begin
        product = '0;
        for (int n = 0; n < 11; n++)
          if (step_size_i[n] && (Steps == 1 || n == s))
            product = product | (ProductBits'(delta) << n);
        extra = 1'b0;
        for (int b = 0; b < Dropped; b++)
          extra = extra | (changes[s*FractionBits+b] & delta[Dropped-1-b]);
        if (step_size_i[s] || Steps == 1)
          move = move + WordBits'(product >> Dropped) + WordBits'(extra);
      end
    end

    logic subtract;
    logic [WordBits-1:0] change;
    always_comb begin
      subtract = 1'b0;
      change = '0;
      if (tracer_reset_i && ext_i) begin
        subtract = ext_sign_i[a];
        if (axis_mask_i[a]) change = WordBits'(delta) << Fraction2;
      end else if (step_i && (!tracer_reset_i || axis_mask_i[a])) begin
        subtract = neg_i;
        change = move;
      end
      if (load_i) dr2_d = load_zero_i ? '0 : WordBits'(dr1_q) << (Fraction2 - Fraction1);
      else dr2_d = subtract ? dr2_q - change : dr2_q + change;
    end

    always_ff @(posedge clk_i) begin
      if (copy) dr1_q <= Word1Bits'(dr2_q >> (Fraction2 - Fraction1));
      dr2_q <= dr2_d;
    end
  end
endmodule

`default_nettype wire
