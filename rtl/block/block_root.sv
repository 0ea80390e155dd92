// block_root: square root of a 3.20 number.
// Contract: sc/block/block_root.h
//
// Halving a float's exponent halves what is below the leading one too. Of an even place of the
// leading one the root is 1 + m/2, of an odd one 3/2 + m/2, shifted.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module block_root #(
    parameter int Root = 0  // 0: bits, 1: heron, 2: exact
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // block_core
    input  wire logic start_i,
    input  wire logic [block_pkg::BlockRootBits-1:0] d_i,
    output logic [block_pkg::BlockRootBits-1:0] root_o,
    output logic done_o
);
  localparam int Bits = block_pkg::BlockRootBits;
  localparam int Fraction = block_pkg::BlockFraction;
  localparam int MostShift = 13;  // of place 0
  localparam int NumberBits = 24;
  localparam logic [3:0] LastStep = Root == 0 ? 4'd0 : Root == 1 ? 4'd8 : 4'd11;
  localparam int SquareBits = 44;

  logic [3:0] step_q;  // clocks that are over; 0: idle, too
  /* verilator lint_off UNUSEDSIGNAL */  // without digits
  logic [NumberBits-1:0] remainder_q, remainder_d, found_q, found_d;
  /* verilator lint_on UNUSEDSIGNAL */

  // --- Of the bits of a float ------------------------------------------------------------------

  /* verilator lint_off UNUSEDSIGNAL */  // the leading one itself, and where none is
  logic [4:0] place;  // of the leading one
  logic [Bits-1:0] aligned;  // the leading one on top
  always_comb begin
    place = '0;
    for (int n = 0; n < Bits; n++) if (d_i[n]) place = 5'(n);
    aligned = d_i << (5'(Bits - 1) - place);
  end

  wire logic [3:0] shift = 4'(MostShift) - place[4:1];
  wire logic [Bits:0] root = {1'b1, place[0], aligned[Bits-2:0]};  // 1.23
  wire logic [Bits:0] whole;
  wire logic [MostShift-1:0] below;
  /* verilator lint_on UNUSEDSIGNAL */
  assign {whole, below} = {root, {MostShift{1'b0}}} >> shift;
  wire logic up = below[MostShift-1] && (below[MostShift-2:0] != '0 || whole[0]);  // half: to even

  wire logic [Bits-1:0] estimate = d_i == '0 ? '0 : whole[Bits-1:0] + Bits'(up);

  // --- Digits ----------------------------------------------------------------------------------
  /* verilator lint_off UNUSEDSIGNAL */
  wire logic first = step_q == '0;
  /* verilator lint_on UNUSEDSIGNAL */
  wire logic last = step_q == LastStep;

  if (Root == 1) begin : g_heron  // three bits of (d << 20) / estimate
    wire logic [NumberBits-1:0] divisor = NumberBits'(estimate);
    wire logic [NumberBits-1:0] rest = {d_i[3:0], {Fraction{1'b0}}} << (6'(step_q) * 6'd3);
    always_comb begin
      remainder_d = first ? NumberBits'(d_i[Bits-1:4]) : remainder_q;
      found_d = first ? '0 : found_q;
      for (int n = NumberBits - 1; n > NumberBits - 4; n--) begin
        remainder_d = {remainder_d[NumberBits-2:0], rest[n]};
        found_d = {found_d[NumberBits-2:0], remainder_d >= divisor};
        if (found_d[0]) remainder_d = remainder_d - divisor;
      end
    end
    assign root_o = d_i == '0 ? '0 : Bits'((NumberBits'(estimate) + found_q) >> 1);
  end else if (Root == 2) begin : g_exact  // two digits of the root of d << 20
    wire logic [SquareBits-1:0] square = {1'b0, d_i, {Fraction{1'b0}}} << {step_q, 2'b00};
    logic [NumberBits-1:0] trial;
    always_comb begin
      remainder_d = first ? '0 : remainder_q;
      found_d = first ? '0 : found_q;
      trial = '0;
      for (int n = SquareBits - 1; n > SquareBits - 4; n -= 2) begin
        remainder_d = {remainder_d[NumberBits-3:0], square[n-:2]};
        trial = {found_d[NumberBits-3:0], 2'b01};
        found_d = {found_d[NumberBits-2:0], remainder_d >= trial};
        if (found_d[0]) remainder_d = remainder_d - trial;
      end
    end
    assign root_o = found_q[Bits-1:0];
  end else begin : g_bits
    assign {remainder_d, found_d} = '0;
    assign root_o = estimate;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni || !start_i || last) step_q <= '0;
    else step_q <= step_q + 1'b1;
    if (start_i && !last) {remainder_q, found_q} <= {remainder_d, found_d};
  end

  assign done_o = last;
endmodule

`default_nettype wire
