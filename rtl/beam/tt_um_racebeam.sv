// tt_um_racebeam: the chip behind the pins of a Tiny Tapeout tile; info.yaml describes the project.
// Contract: section 4, pins. ui_in is sampled without synchronisers, as on the chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module tt_um_racebeam (
    input wire logic [7:0] ui_in,  // {-, -, -, -, no_interlace, speed[2:0]}
    output logic [7:0] uo_out,  // TinyVGA: {hsync, B0, G0, R0, vsync, B1, G1, R1}
    input wire logic [7:0] uio_in,
    output logic [7:0] uio_out,  // {sound, -, -, -, -, -, -, -}
    output logic [7:0] uio_oe,
    input wire logic ena,  // 1 while the design has power
    input wire logic clk,  // 50.4 MHz
    input wire logic rst_n
);
  wire logic [7:0] uo;
  wire logic pwm;

  racebeam_top u_racebeam_top (
      .clk_i(clk),
      .rst_ni(rst_n),
      .speed_i(ui_in[2:0]),
      .no_interlace_i(ui_in[3]),
      .uo_o(uo),
      .pwm_o(pwm)
  );

  assign uo_out = uo;
  assign uio_out = {pwm, 7'd0};
  assign uio_oe = 8'h80;

  wire logic unused = &{ena, ui_in[7:4], uio_in};
endmodule

`default_nettype wire
