// Counters of 640x480 at 60 Hz, and negative syncs that fit them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
module paddle_beam (
    input  logic       clk,
    input  logic       rst_n,
    output logic [9:0] x_q,
    output logic [9:0] y_q,
    output logic       hsync,
    output logic       vsync,
    output logic       visible,
    output logic       last      // clock of the frame
);
  assign hsync   = !(x_q >= 656 && x_q < 752);
  assign vsync   = !(y_q >= 490 && y_q < 492);
  assign visible = x_q < 640 && y_q < 480;
  assign last    = x_q == 799 && y_q == 524;

  always_ff @(posedge clk)
    if (!rst_n) begin
      x_q <= 0;
      y_q <= 0;
    end else begin
      x_q <= x_q == 799 ? 10'd0 : x_q + 1;
      if (x_q == 799) y_q <= y_q == 524 ? 10'd0 : y_q + 1;
    end
endmodule
