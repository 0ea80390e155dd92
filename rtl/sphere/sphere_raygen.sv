// sphere_raygen: the direction of the ray through a point of the screen.
// Contract: sc/sphere/sphere_raygen.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module sphere_raygen #(
    parameter int Wide = 0
) (
    // sphere_tracer
    input  wire logic [racebeam_pkg::PixelBits-1:0] x_i,
    input  wire logic [racebeam_pkg::PixelBits-1:0] y_i,
    input  wire logic [3:0] sub_i,
    output logic [sphere_pkg::SphereBits-1:0] direction_x_o,  // signed
    output logic [sphere_pkg::SphereBits-1:0] direction_y_o,
    output logic [sphere_pkg::SphereBits-1:0] direction_z_o,
    // sphere_inputs
    input  wire logic [sphere_pkg::SphereBits-1:0] origin_x_i,  // signed
    input  wire logic [sphere_pkg::SphereBits-1:0] origin_y_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] origin_z_i,
    input  wire logic [sphere_pkg::SphereBits-1:0] screen_i,  // signed
    input  wire logic narrow_i
);
  typedef logic signed [sphere_pkg::SphereBits-1:0] number;

  localparam int HalfPixel = sphere_pkg::SphereFraction - 1;
  localparam int Nearer = 5;  // everything is divided by 32
  localparam number WideColumns = Wide != 0 ? 24'sd640 : 24'sd512;

  logic signed [1:0] offset_x, offset_y;  // half pixels
  always_comb begin
    unique case (sub_i)
      4'd1: {offset_x, offset_y} = {-2'sd1, -2'sd1};
      4'd2: {offset_x, offset_y} = {-2'sd1, 2'sd1};
      4'd3: {offset_x, offset_y} = {2'sd1, -2'sd1};
      4'd4: {offset_x, offset_y} = {2'sd1, 2'sd1};
      4'd5: {offset_x, offset_y} = {-2'sd1, 2'sd0};
      4'd6: {offset_x, offset_y} = {2'sd0, 2'sd1};
      4'd7: {offset_x, offset_y} = {2'sd0, -2'sd1};
      4'd8: {offset_x, offset_y} = {2'sd1, 2'sd0};
      default: {offset_x, offset_y} = {2'sd0, 2'sd0};
    endcase
  end

  // A coordinate of the screen, from the middle of the picture, less the eye's.
  function automatic number along(input logic [racebeam_pkg::PixelBits-1:0] pixel,
                                  input logic signed [1:0] offset, input number size,
                                  input number origin);
    number place;
    place = $signed(24'({pixel, 1'b0})) + 24'(offset);
    place = (place <<< HalfPixel) >>> Nearer;
    along = place - (size <<< (sphere_pkg::SphereFraction - 1 - Nearer)) - (origin >>> Nearer);
  endfunction

  wire number eye_z = origin_z_i;
  wire number back = eye_z >>> Nearer;

  assign direction_x_o = along(x_i, offset_x, narrow_i ? 24'sd320 : WideColumns, origin_x_i);
  assign direction_y_o = along(y_i, offset_y, narrow_i ? 24'sd240 : 24'sd480, origin_y_i);
  assign direction_z_o = screen_i - back;
endmodule

`default_nettype wire
