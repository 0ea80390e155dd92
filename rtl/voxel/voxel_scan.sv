// voxel_scan: takes the rays of a picture through its pixels, line by line, left to right.
// Contract: sc/voxel/voxel_scan.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_scan #(
    parameter int PictureWidth = 640,
    parameter int PictureHeight = 480,
    parameter int MaxOuter = 100,
    parameter int MaxInner = 100,
    parameter int Shadows = 0,
    parameter int ShadowOuter = 20,
    parameter int ShadowInner = 20
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // Host
    input  wire logic start_i,
    output logic picture_done_o,
    // voxel_camera
    output logic camera_start_o,
    output logic next_pixel_o,
    output logic next_line_o,
    // voxel_walker, start_o to voxel_limits too
    output logic start_o,
    output logic shadow_o,  // with start_o
    input  wire logic ray_done_i,
    input  wire logic [voxel_pkg::VoxelKindBits-1:0] kind_i,
    // voxel_limits, with start_o
    output logic [voxel_pkg::VoxelLimitBits-1:0] max_outer_o,
    output logic [voxel_pkg::VoxelLimitBits-1:0] max_inner_o,
    // voxel_shade
    output logic take_o,
    output logic shade_o,
    output logic shadowed_o,  // with shade_o
    input  wire logic done_i,
    input  wire logic [voxel_pkg::VoxelColourBits-1:0] colour_i,
    // write_buffer
    output logic put_valid_o,
    output logic [19:0] put_address_o,
    output logic [63:0] put_data_o,
    input  wire logic put_ready_i,
    // For counters
    output logic [voxel_pkg::VoxelScanStateBits-1:0] state_o
);
  localparam int LimitBits = voxel_pkg::VoxelLimitBits;
  localparam int RowBits = voxel_pkg::VoxelRowBits;
  localparam int PlaceBits = voxel_pkg::VoxelPlaceBits;

  logic [voxel_pkg::VoxelScanStateBits-1:0] state_q, state_d;
  logic [RowBits-1:0] row_q, row_d;
  logic [PlaceBits-1:0] column_q, column_d;

  wire logic in_ray = state_q == voxel_pkg::VoxelScanRay;
  wire logic in_shadow = state_q == voxel_pkg::VoxelScanShadow;
  wire logic in_shade = state_q == voxel_pkg::VoxelScanShade;

  wire logic hit = kind_i == voxel_pkg::VoxelHit;
  wire logic lit = Shadows == 1 && hit;  // unless something is in the way
  wire logic last_of_line = column_q == PlaceBits'(PictureWidth - 1);
  wire logic last = last_of_line && row_q == RowBits'(PictureHeight - 1);
  wire logic ends = put_valid_o && put_ready_i;

  assign camera_start_o = state_q == voxel_pkg::VoxelScanIdle && start_i;
  assign next_pixel_o = ends && !last_of_line;
  assign next_line_o = ends && last_of_line && !last;
  assign picture_done_o = ends && last;

  assign start_o = camera_start_o || in_ray && ray_done_i && lit || ends && !last;
  assign shadow_o = in_ray;
  assign max_outer_o = in_ray ? LimitBits'(ShadowOuter) : LimitBits'(MaxOuter);
  assign max_inner_o = in_ray ? LimitBits'(ShadowInner) : LimitBits'(MaxInner);

  assign take_o = in_ray && ray_done_i;
  assign shade_o = ray_done_i && (in_shadow || in_ray && !lit);
  assign shadowed_o = ray_done_i && in_shadow && hit;

  assign put_valid_o = in_shade && done_i;
  assign put_address_o = 20'({row_q, column_q});
  assign put_data_o = 64'(colour_i);
  assign state_o = state_q;

  always_comb begin
    {state_d, row_d, column_d} = {state_q, row_q, column_q};
    if (shade_o) state_d = voxel_pkg::VoxelScanShade;
    else if (start_o) state_d = in_ray ? voxel_pkg::VoxelScanShadow : voxel_pkg::VoxelScanRay;
    else if (picture_done_o) state_d = voxel_pkg::VoxelScanIdle;
    if (next_pixel_o) column_d = column_q + 1'b1;
    if (next_line_o) {row_d, column_d} = {row_q + 1'b1, PlaceBits'(0)};
    if (picture_done_o) {row_d, column_d} = '0;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) {state_q, row_q, column_q} <= '0;
    else {state_q, row_q, column_q} <= {state_d, row_d, column_d};
  end
endmodule

`default_nettype wire
