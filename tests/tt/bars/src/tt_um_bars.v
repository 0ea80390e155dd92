// Colour bars: both syncs positive, colours not registered, a tone of the lines' rate / 32.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module tt_um_bars (
    input wire [7:0] ui_in,  // colours are XORed with its low six bits
    output wire [7:0] uo_out,
    input wire [7:0] uio_in,  // shown by uio_out[6:0]
    output wire [7:0] uio_out,
    output wire [7:0] uio_oe,
    input wire ena,
    input wire clk,
    input wire rst_n
);
  wire hsync, vsync, display_on;
  wire [9:0] hpos, vpos;
  reg [7:0] palette[0:7];  // {2 unused, R, G, B}, two bits each
  initial $readmemh("palette.hex", palette);

  hvsync_generator hvsync_gen (
      .clk(clk),
      .reset(~rst_n),
      .hsync(hsync),
      .vsync(vsync),
      .display_on(display_on),
      .hpos(hpos),
      .vpos(vpos)
  );

  wire [2:0] bar = hpos / 80;  // wider than the wire, which Verilator's lint remarks
  wire [2:0] band = vpos / 60;
  wire [5:0] rgb = display_on ? palette[bar ^ band][5:0] ^ ui_in[5:0] : 6'd0;
  assign uo_out = {hsync, rgb[0], rgb[2], rgb[4], vsync, rgb[1], rgb[3], rgb[5]};

  assign uio_out = {vpos[4], uio_in[6:0]};
  assign uio_oe = 8'h80;
  wire unused = &uio_in[7];
endmodule
