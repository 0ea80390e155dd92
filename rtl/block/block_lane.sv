// block_lane: one sphere against one ray.
// Contract: sc/block/block_lane.h
//
// Four multipliers; the register is without reset.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module block_lane (
    // Clock
    input  wire logic clk_i,
    // block_core
    input  wire logic secondary_i,  // the second clock of a later pass
    input  wire logic [block_pkg::BlockBits-1:0] a_x_i,  // signed, all of them
    input  wire logic [block_pkg::BlockBits-1:0] a_y_i,
    input  wire logic [block_pkg::BlockBits-1:0] a_z_i,
    input  wire logic [block_pkg::BlockBits-1:0] dir_x_i,
    input  wire logic [block_pkg::BlockBits-1:0] dir_y_i,
    input  wire logic [block_pkg::BlockBits-1:0] dir_z_i,
    input  wire logic [block_pkg::BlockBits-1:0] k_i,
    output logic [block_pkg::BlockBits-1:0] b_o,
    output logic [block_pkg::BlockDistanceBits-1:0] d_o
);
  localparam int Bits = block_pkg::BlockBits;
  localparam int LongBits = block_pkg::BlockDistanceBits;

  block_pkg::number b_q;

  function automatic logic [LongBits-1:0] long_of(input block_pkg::number value);
    long_of = {value[Bits-1], value};
  endfunction

  wire block_pkg::number right_x = secondary_i ? a_x_i : dir_x_i;
  wire block_pkg::number right_y = secondary_i ? a_y_i : dir_y_i;
  wire block_pkg::number right_z = secondary_i ? a_z_i : dir_z_i;
  wire block_pkg::product product_x = $signed(a_x_i) * right_x;
  wire block_pkg::product product_y = $signed(a_y_i) * right_y;
  wire block_pkg::product product_z = $signed(a_z_i) * right_z;
  wire block_pkg::number sum = block_pkg::fixed_of(product_x + product_y + product_z);

  wire block_pkg::number b = secondary_i ? b_q : sum;
  wire block_pkg::product square = b * b;

  always_ff @(posedge clk_i) if (!secondary_i) b_q <= sum;

  assign b_o = b;
  assign d_o = long_of(block_pkg::fixed_of(square)) + long_of(k_i)
      - (secondary_i ? long_of(sum) : '0);
endmodule

`default_nettype wire
