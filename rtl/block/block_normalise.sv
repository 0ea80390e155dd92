// block_normalise: the unit vector of a vector, by an estimate of 1 / length and Newton's steps.
// Contract: sc/block/block_normalise.h
//
// Three multipliers: the squares, one product of a step, the scaling. The registers of the
// numbers are without reset.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module block_normalise #(
    parameter int NewtonSteps = 2
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // block_core
    input  wire logic start_i,
    input  wire logic [block_pkg::BlockBits-1:0] v_x_i,  // signed, all of them
    input  wire logic [block_pkg::BlockBits-1:0] v_y_i,
    input  wire logic [block_pkg::BlockBits-1:0] v_z_i,
    output logic [block_pkg::BlockBits-1:0] unit_x_o,
    output logic [block_pkg::BlockBits-1:0] unit_y_o,
    output logic [block_pkg::BlockBits-1:0] unit_z_o,
    output logic done_o,
    // For counters
    output logic small_o
);
  localparam int Bits = block_pkg::BlockBits;
  localparam int SquareBits = 24;  // of the squared length, below 1024
  localparam logic [3:0] LastStep = 4'(2 + 3 * NewtonSteps);
  localparam logic [Bits-1:0] OneAndHalf = 32'h180000;
  localparam logic [30:0] Magic = 31'h5f3759df;

  logic [3:0] step_q, step_d;  // clocks that are over; 0: idle too
  logic [1:0] part_q, part_d;  // of a Newton step
  block_pkg::number aa_q, x_q, x_d, t_q, t_d;

  wire logic first = step_q == '0;
  wire logic last = step_q == LastStep;

  // --- The estimate: half of the float's bits, taken from a constant ---------------------------
  /* verilator lint_off UNUSEDSIGNAL */  // the leading one itself, and what no aa has
  logic [4:0] place;  // of the leading one
  logic [SquareBits-1:0] aligned;
  wire logic [SquareBits-1:0] square = aa_q[6+:SquareBits];  // in 2^-14
  always_comb begin
    place = '0;
    for (int n = 0; n < SquareBits; n++) if (square[n]) place = 5'(n);
    aligned = square << (5'(SquareBits - 1) - place);
  end

  wire logic [30:0] bits = {8'd113 + 8'(place), aligned[SquareBits-2:0]};
  wire logic [30:0] inverse = Magic - {1'b0, bits[30:1]};
  wire logic [7:0] shift = 8'd136 - inverse[30:23];
  wire logic [23:0] whole;
  wire logic [13:0] below;
  /* verilator lint_on UNUSEDSIGNAL */
  assign {whole, below} = {1'b1, inverse[22:0], 14'd0} >> shift[3:0];
  wire logic up = below[13] && (below[12:0] != '0 || whole[0]);  // half: to even
  wire logic [22:0] rounded = square == '0 ? Magic[22:0] : whole[22:0] + 23'(up);

  // --- Three multipliers -----------------------------------------------------------------------
  block_pkg::number left_x, right_x;
  always_comb begin
    left_x = part_q == 2'd1 ? t_q : x_q;
    unique case (part_q)
      2'd0: right_x = x_q;
      2'd1: right_x = aa_q >>> 1;
      default: right_x = OneAndHalf - t_q;
    endcase
    if (first || last) left_x = v_x_i;
    if (first) right_x = v_x_i;
  end
  wire block_pkg::number right_y = first ? v_y_i : x_q;
  wire block_pkg::number right_z = first ? v_z_i : x_q;
  wire block_pkg::product product_x = left_x * right_x;
  wire block_pkg::product product_y = $signed(v_y_i) * right_y;
  wire block_pkg::product product_z = $signed(v_z_i) * right_z;

  always_comb begin
    step_d = step_q;
    part_d = '0;
    if (first) step_d = 4'(start_i);
    else if (last) step_d = '0;
    else begin
      step_d = step_q + 1'b1;
      if (step_q != 4'd1 && part_q != 2'd2) part_d = part_q + 1'b1;
    end
    x_d = x_q;
    t_d = block_pkg::fixed_of(product_x);
    if (step_q == 4'd1) x_d = {3'd0, rounded, 6'd0};
    else if (part_q == 2'd2) x_d = block_pkg::fixed_of(product_x);
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      step_q <= '0;
      part_q <= '0;
    end else begin
      step_q <= step_d;
      part_q <= part_d;
    end
    if (first && start_i) aa_q <= block_pkg::fixed_of(product_x + product_y + product_z);
    if (!first && !last) begin
      x_q <= x_d;
      t_q <= t_d;
    end
  end

  assign unit_x_o = last ? block_pkg::fixed_of(product_x) : '0;
  assign unit_y_o = last ? block_pkg::fixed_of(product_y) : '0;
  assign unit_z_o = last ? block_pkg::fixed_of(product_z) : '0;
  assign done_o = last;
  assign small_o = step_q == 4'd1 && aa_q < block_pkg::BlockSmallLength2;
endmodule

`default_nettype wire
