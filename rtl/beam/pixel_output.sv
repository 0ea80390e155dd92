// pixel_output: colour index of the interval on offer, palette, blanking, pins.
// Contract: sc/beam/pixel_output.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module pixel_output #(
    parameter int Dithering = 1,
    parameter int DrBits = 10
) (
    // Interval on offer
    input wire logic [1:0] hit_face_i,  // axis of the wall
    input wire logic [2:0] ray_signs_i,  // ray signs, 1: negative
    /* verilator lint_off UNUSEDSIGNAL */  // one bit counts
    input wire logic [9:0] y_i,  // bit 0: odd line
    /* verilator lint_on UNUSEDSIGNAL */
    input wire logic shading_b_i,
    input wire logic starving_i,
    output logic [1:0] value_o,
    output logic half_o,  // checkered: half a tone more
    // Pixel on show
    input wire logic [1:0] display_i,  // colour index
    /* verilator lint_off UNUSEDSIGNAL */
    input wire logic display_half_i,
    input wire logic [10:0] x2_i,  // bit 1: odd column
    /* verilator lint_on UNUSEDSIGNAL */
    input wire logic lock_i,
    /* verilator lint_off UNUSEDSIGNAL */  // two bits of each count
    input wire logic signed [racebeam_pkg::DrPortBits-1:0] dr2_x_i,
    input wire logic signed [racebeam_pkg::DrPortBits-1:0] dr2_y_i,
    input wire logic signed [racebeam_pkg::DrPortBits-1:0] dr2_z_i,
    /* verilator lint_on UNUSEDSIGNAL */
    input wire logic inverse_i,
    input wire logic [1:0] palette_i,  // 0..2: the chip's
    input wire logic [racebeam_pkg::ColoursBits-1:0] colours_i,  // palette 3, first lowest
    input wire logic active_i,
    input wire logic hsync_ni,
    input wire logic vsync_ni,
    output logic [7:0] uo_o  // {hsync, B0 G0 R0, vsync, B1 G1 R1}
);
  // --- Index of the interval on offer -----------------------------------------------------------
  wire logic [3:0] signs = {1'b0, ray_signs_i};
  wire logic [2:0] face = {1'b0, hit_face_i};
  wire logic odd = y_i[0] & (Dithering == 1);
  /* verilator lint_off UNUSEDSIGNAL */  // bit 0: the half that is dropped, or on its own way
  wire logic [2:0] half_tones =
      (signs[hit_face_i] ? 3'd6 - face : 3'd1 + face) + 3'(odd);
  /* verilator lint_on UNUSEDSIGNAL */

  always_comb begin
    if (starving_i) value_o = 2'd0;
    else if (shading_b_i) value_o = half_tones[2:1];
    else value_o = 2'd3 - hit_face_i;
  end
  assign half_o = Dithering == 2 && shading_b_i && !starving_i && half_tones[0];

  // --- Index on show ----------------------------------------------------------------------------
  // Bits 6:5, 5:4 and 7:6 of x, z and y of the chip's 10-bit direction.
  wire logic [1:0] pattern =
      (dr2_x_i[DrBits-4-:2] | dr2_z_i[DrBits-5-:2]) & dr2_y_i[DrBits-3-:2];
  wire logic raised = Dithering == 2 && display_half_i && x2_i[1] != y_i[0];
  wire logic [1:0] plain = lock_i ? pattern : display_i + 2'(raised);
  wire logic [1:0] index = {plain[1], plain[0] ^ (inverse_i & plain[1])};

  // --- Colour {R, G, B}, 2 bits each ------------------------------------------------------------
  logic [racebeam_pkg::ColourBits-1:0] colour;
  always_comb begin
    unique case ({palette_i, index})
      4'h0: colour = {2'd0, 2'd0, 2'd0};
      4'h1: colour = {2'd0, 2'd0, 2'd1};
      4'h2: colour = {2'd0, 2'd1, 2'd2};
      4'h3: colour = {2'd2, 2'd2, 2'd3};
      4'h4: colour = {2'd0, 2'd0, 2'd2};
      4'h5: colour = {2'd0, 2'd1, 2'd2};
      4'h6: colour = {2'd1, 2'd2, 2'd2};
      4'h7: colour = {2'd1, 2'd3, 2'd2};
      4'h8: colour = {2'd1, 2'd0, 2'd1};
      4'h9: colour = {2'd2, 2'd1, 2'd1};
      4'ha: colour = {2'd3, 2'd2, 2'd1};
      4'hb: colour = {2'd3, 2'd3, 2'd2};
      4'hc: colour = colours_i[5:0];
      4'hd: colour = colours_i[11:6];
      4'he: colour = colours_i[17:12];
      4'hf: colour = colours_i[23:18];
    endcase
    if (!active_i) colour = '0;
  end

  assign uo_o = {
    hsync_ni, colour[0], colour[2], colour[4], vsync_ni, colour[1], colour[3], colour[5]
  };
endmodule

`default_nettype wire
