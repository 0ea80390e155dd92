// A white bar, 64 pixels wide: ui[0] moves it to the left, ui[1] to the right, 8 pixels before each
// picture. Rows 0 to 255 show in blue where ui[2] is 1 just then. uio[1:0] is the tone's octave.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module tt_um_paddle (
    input  wire [7:0] ui_in,
    output wire [7:0] uo_out,
    input  wire [7:0] uio_in,
    output wire [7:0] uio_out,
    output wire [7:0] uio_oe,
    input  wire       ena,
    input  wire       clk,
    input  wire       rst_n
);
  logic [9:0] x, y, left_q;
  logic [7:0] frame_q;
  logic hsync, vsync, visible, last;

  paddle_beam u_beam (
      .clk    (clk),
      .rst_n  (rst_n),
      .x_q    (x),
      .y_q    (y),
      .hsync  (hsync),
      .vsync  (vsync),
      .visible(visible),
      .last   (last)
  );

  always_ff @(posedge clk)
    if (!rst_n) begin
      left_q  <= 288;
      frame_q <= 0;
    end else if (last) begin
      frame_q <= frame_q + 1;
      if (ui_in[0] && left_q > 0) left_q <= left_q - 8;
      if (ui_in[1] && left_q < 576) left_q <= left_q + 8;
    end

  wire bar = visible && x >= left_q && x < left_q + 64;
  wire now = visible && y < 256 && ui_in[2];
  assign uo_out = {hsync, now || bar, bar, bar, vsync, now || bar, bar, bar};
  assign uio_out = {y[5-uio_in[1:0]], 7'd0};
  assign uio_oe = 8'h80;
  wire unused = &{ena, ui_in[7:3], uio_in[7:2], frame_q};
endmodule
