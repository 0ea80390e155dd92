// root_unit: square root of a 12.12 number, digit by digit.
// Contract: sc/sphere/root_unit.h
//
// Digits are taken in whole rounds: the radicand has so many zeros before it that the last round
// ends with the last digit. The registers of the digits are without reset.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module root_unit #(
    parameter int RootBitsPerClock = 6
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // sphere_tracer
    input  wire logic start_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] radicand_i,
    output logic [sphere_pkg::SphereBits-1:0] root_o,
    output logic done_o
);
  localparam int Digits = 22;  // 10 before the point, 6 of a 12.12 number's half and 6 more
  localparam int Rounds = (Digits + RootBitsPerClock - 1) / RootBitsPerClock;
  localparam int PairBits = 2 * Rounds * RootBitsPerClock;
  localparam int RootBits = 18;  // the others are 0
  localparam logic [4:0] LastStep = 5'(Rounds + 1);

  logic start_q, done_q, done_d;
  logic [4:0] step_q, step_d;  // 0: idle, 1: loads, from 2 on: digits
  logic [PairBits-1:0] pairs_q, pairs_d;  // two bits for each digit to come
  logic [RootBits+2:0] remainder_q, remainder_d;
  logic [RootBits-1:0] digits_q, digits_d;
  logic [RootBits-1:0] root_q, root_d;

  always_comb begin
    pairs_d = pairs_q;
    remainder_d = remainder_q;
    digits_d = digits_q;
    for (int n = 0; n < RootBitsPerClock; n++) begin
      remainder_d = {remainder_d[RootBits:0], pairs_d[PairBits-1-:2]};
      pairs_d = pairs_d << 2;
      if (remainder_d >= {1'b0, digits_d, 2'b01}) begin
        remainder_d = remainder_d - {1'b0, digits_d, 2'b01};
        digits_d = {digits_d[RootBits-2:0], 1'b1};
      end else begin
        digits_d = {digits_d[RootBits-2:0], 1'b0};
      end
    end
    if (step_q == 5'd1) begin
      pairs_d = PairBits'({radicand_i, 12'd0});
      remainder_d = '0;
      digits_d = '0;
    end
  end

  always_comb begin
    step_d = step_q;
    done_d = done_q;
    root_d = root_q;
    if (!start_i) begin
      step_d = '0;
      done_d = 1'b0;
    end else if (step_q == '0) begin
      if (!start_q) step_d = 5'd1;
    end else if (step_q == LastStep) begin
      step_d = '0;
      done_d = 1'b1;
      root_d = digits_d;
    end else begin
      step_d = step_q + 1'b1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      start_q <= 1'b0;
      step_q <= '0;
      done_q <= 1'b0;
      root_q <= '0;
    end else begin
      start_q <= start_i;
      step_q <= step_d;
      done_q <= done_d;
      root_q <= root_d;
    end
    pairs_q <= pairs_d;
    remainder_q <= remainder_d;
    digits_q <= digits_d;
  end

  assign root_o = sphere_pkg::SphereBits'(root_q);
  assign done_o = done_q;
endmodule

`default_nettype wire
