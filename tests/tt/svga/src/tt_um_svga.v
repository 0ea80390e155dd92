// Checks of 100 pixels in an edge of one colour, at 800x600.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`include "svga.vh"
`default_nettype none

module tt_um_svga (
    input wire [7:0] ui_in,
    output wire [7:0] uo_out,
    input wire [7:0] uio_in,
    output wire [7:0] uio_out,
    output wire [7:0] uio_oe,
    input wire ena,
    input wire clk,
    input wire rst_n
);
  reg [10:0] x;
  reg [9:0] y;
  wire last = x == `H_TOTAL - 1;
  always @(posedge clk)
    if (!rst_n) begin
      x <= 0;
      y <= 0;
    end else begin
      x <= last ? 0 : x + 1;
      if (last) y <= y == `V_TOTAL - 1 ? 0 : y + 1;
    end

  /* verilator lint_off WIDTHEXPAND */
  /* verilator lint_off NAMEOFANOTHERYEAR */
  wire hsync = x >= `H_SYNC_START && x < `H_SYNC_END;
  wire vsync = y >= `V_SYNC_START && y < `V_SYNC_END;
  wire edge_of_it = x == 0 || x == `H_DISPLAY - 1 || y == 0 || y == `V_DISPLAY - 1;
  wire check = (x / 100 + y / 100) % 2 == 1;
  wire [5:0] inner = check ? 6'd48 : 6'd3;
  wire [5:0] rgb = x < `H_DISPLAY && y < `V_DISPLAY ? (edge_of_it ? `EDGE : inner) : 6'd0;
  assign uo_out = {hsync, rgb[0], rgb[2], rgb[4], vsync, rgb[1], rgb[3], rgb[5]};
  assign uio_out = 0;
  assign uio_oe = 0;
  wire unused = &{ui_in, uio_in, ena};
endmodule
