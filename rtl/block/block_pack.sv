// block_pack: eight pixels as three words, one a colour plane.
// Contract: sc/block/block_pack.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module block_pack (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // block_core
    input  wire logic valid_i,
    input  wire logic [7:0] red_i,
    input  wire logic [7:0] green_i,
    input  wire logic [7:0] blue_i,
    output logic [63:0] red_o,  // the first pixel in the lowest byte
    output logic [63:0] green_o,
    output logic [63:0] blue_o,
    output logic full_o  // with this pixel there are eight
);
  logic [63:0] red_q, green_q, blue_q;
  logic [2:0] count_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      count_q <= '0;
      red_q <= '0;
      green_q <= '0;
      blue_q <= '0;
    end else if (valid_i) begin
      count_q <= count_q + 1'b1;
      red_q <= {red_i, red_q[63:8]};
      green_q <= {green_i, green_q[63:8]};
      blue_q <= {blue_i, blue_q[63:8]};
    end
  end

  assign red_o = red_q;
  assign green_o = green_q;
  assign blue_o = blue_q;
  assign full_o = valid_i && count_q == '1;
endmodule

`default_nettype wire
