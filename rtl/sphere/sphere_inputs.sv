// sphere_inputs: switches and keys of the board, and what they move: light, eye, screen.
// Contract: sc/sphere/sphere_inputs.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module sphere_inputs #(
    // Where a reset puts eye, light and screen, 12.12
    parameter int OriginX = 0,
    parameter int OriginY = 0,
    parameter int OriginZ = -131072,
    parameter int LightX = 61440,
    parameter int LightY = 61440,
    parameter int LightZ = -4096,
    parameter int Screen = 32768
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    output logic rst_no,
    // Pins of the chip
    input  wire logic [17:0] sw_i,
    input  wire logic [3:0] key_ni,
    output logic [7:0] rotz_o,  // to the CPU: turns that are wanted
    // sphere_tracer
    input  wire logic picture_done_i,
    output logic [sphere_pkg::SphereBits-1:0] origin_x_o,  // signed
    output logic [sphere_pkg::SphereBits-1:0] origin_y_o,
    output logic [sphere_pkg::SphereBits-1:0] origin_z_o,
    output logic [sphere_pkg::SphereBits-1:0] light_x_o,  // signed
    output logic [sphere_pkg::SphereBits-1:0] light_y_o,
    output logic [sphere_pkg::SphereBits-1:0] light_z_o,
    output logic [1:0] max_reflections_o,
    output logic [1:0] alias_o,  // 0: none, 1: 4x, 2: 8x
    output logic narrow_o,
    output logic planes_o,
    // sphere_raygen
    output logic [sphere_pkg::SphereBits-1:0] screen_o,  // signed
    // sphere_host_link
    output logic scene_o  // built-in scene, if there is no CPU
);
  typedef logic [sphere_pkg::SphereBits-1:0] number;

  localparam number Step = sphere_pkg::SphereBits'(1 << sphere_pkg::SphereFraction);
  localparam number Zoom = sphere_pkg::SphereBits'(1 << (sphere_pkg::SphereFraction - 4));

  number origin_x_q, origin_y_q, origin_z_q, light_x_q, light_y_q, light_z_q, screen_q;
  logic [5:0] rotz_q;
  logic [1:0] max_reflections_q, alias_q;
  logic narrow_q, planes_q, scene_q;

  function automatic number moved(input number from, input logic up, input logic down,
                                  input number by);
    moved = up == down ? from : up ? from + by : from - by;
  endfunction

  assign rst_no = rst_ni && key_ni[3];

  always_ff @(posedge clk_i) begin
    if (!rst_no) begin
      origin_x_q <= sphere_pkg::SphereBits'(OriginX);
      origin_y_q <= sphere_pkg::SphereBits'(OriginY);
      origin_z_q <= sphere_pkg::SphereBits'(OriginZ);
      light_x_q <= sphere_pkg::SphereBits'(LightX);
      light_y_q <= sphere_pkg::SphereBits'(LightY);
      light_z_q <= sphere_pkg::SphereBits'(LightZ);
      screen_q <= sphere_pkg::SphereBits'(Screen);
      rotz_q <= '0;
      planes_q <= !key_ni[2];
    end else if (picture_done_i) begin
      light_x_q <= moved(light_x_q, sw_i[17], sw_i[16], Step);
      light_y_q <= moved(light_y_q, sw_i[15], sw_i[14], Step);
      light_z_q <= moved(light_z_q, sw_i[13], sw_i[12], Step);
      origin_x_q <= moved(origin_x_q, sw_i[11], sw_i[10], Step);
      origin_y_q <= moved(origin_y_q, sw_i[9], sw_i[8], Step);
      origin_z_q <= moved(origin_z_q, sw_i[7], sw_i[6], Step);
      screen_q <= moved(screen_q, !key_ni[0], !key_ni[1], Zoom);
      rotz_q <= {&sw_i[17:16], &sw_i[15:14], &sw_i[13:12], &sw_i[11:10], &sw_i[9:8], &sw_i[7:6]};
    end
    if (!rst_no || picture_done_i) begin
      narrow_q <= !sw_i[5];
      scene_q <= sw_i[4];
      max_reflections_q <= sw_i[3:2];
      alias_q <= sw_i[1] ? 2'd2 : {1'b0, sw_i[0]};
    end
  end

  assign rotz_o = {2'b0, rotz_q};
  assign origin_x_o = origin_x_q;
  assign origin_y_o = origin_y_q;
  assign origin_z_o = origin_z_q;
  assign light_x_o = light_x_q;
  assign light_y_o = light_y_q;
  assign light_z_o = light_z_q;
  assign max_reflections_o = max_reflections_q;
  assign alias_o = alias_q;
  assign narrow_o = narrow_q;
  assign planes_o = planes_q;
  assign screen_o = screen_q;
  assign scene_o = scene_q;
endmodule

`default_nettype wire
