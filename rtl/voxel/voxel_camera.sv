// voxel_camera: directions of the rays of a picture, by sums.
// Contract: sc/voxel/voxel_camera.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_camera (
    // Clock
    input  wire logic clk_i,
    // Host: signed 2.24
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] d00_x_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] d00_y_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] d00_z_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] dx_x_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] dx_y_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] dx_z_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] dy_x_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] dy_y_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] dy_z_i,
    // voxel_scan
    input  wire logic start_i,
    input  wire logic next_pixel_i,
    input  wire logic next_line_i,
    // voxel_walker
    output logic [voxel_pkg::VoxelDirectionBits-1:0] direction_x_o,  // signed
    output logic [voxel_pkg::VoxelDirectionBits-1:0] direction_y_o,
    output logic [voxel_pkg::VoxelDirectionBits-1:0] direction_z_o
);
  localparam int Bits = voxel_pkg::VoxelCameraBits;
  typedef logic [3*Bits-1:0] axes;  // {x, y, z}

  function automatic axes plus(input axes a, input axes b);
    plus = {a[2*Bits+:Bits] + b[2*Bits+:Bits], a[Bits+:Bits] + b[Bits+:Bits],
            a[0+:Bits] + b[0+:Bits]};
  endfunction

  axes line_q, line_d, pixel_q, pixel_d;

  always_comb begin
    line_d = line_q;
    pixel_d = pixel_q;
    if (start_i) begin
      line_d = {d00_x_i, d00_y_i, d00_z_i};
      pixel_d = line_d;
    end else if (next_line_i) begin
      line_d = plus(line_q, {dy_x_i, dy_y_i, dy_z_i});
      pixel_d = line_d;
    end else if (next_pixel_i) begin
      pixel_d = plus(pixel_q, {dx_x_i, dx_y_i, dx_z_i});
    end
  end

  always_ff @(posedge clk_i) begin
    {line_q, pixel_q} <= {line_d, pixel_d};
  end

  localparam int Cut = 24 - voxel_pkg::VoxelDirectionFraction;  // of 2.24
  assign direction_x_o = pixel_q[2*Bits+Cut+:voxel_pkg::VoxelDirectionBits];
  assign direction_y_o = pixel_q[Bits+Cut+:voxel_pkg::VoxelDirectionBits];
  assign direction_z_o = pixel_q[Cut+:voxel_pkg::VoxelDirectionBits];
endmodule

`default_nettype wire
