// voxel_top: all units of the voxel tracer wired under one clock; its memories are outside.
// Contract: sc/voxel/voxel_chip.h, whose wires these are.
//
// No arithmetic: a wire has the name of the port that drives it, without its suffix; where two units
// have such a port, or the language the word, it is named as in voxel_chip, or nearly. What the host
// writes into columns goes straight through to their memory.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_top #(
    parameter int SizeX = 64,
    parameter int SizeY = 64,
    parameter int SizeZ = 32,
    parameter int VoxelX = 1,
    parameter int VoxelY = 4,
    parameter int VoxelZ = 1,
    parameter int Levels = 5,
    parameter int MaxOuter = 100,
    parameter int MaxInner = 100,
    parameter int Leaf = 0,
    parameter int LeafSteps = 1,
    parameter int Raise = 0,
    parameter int GroupFetch = 0,
    parameter int Shading = 0,
    parameter int Sky = 0,
    parameter int Shadows = 0,
    parameter int ShadowOuter = 20,
    parameter int ShadowInner = 20,
    parameter int DebugLimits = 0,
    parameter int MemoryClocks = 1,
    parameter int PictureWidth = 64,
    parameter int PictureHeight = 48,
    parameter int WriteBufferDepth = 64,
    parameter int WritePolicy = 2,
    parameter int WhenFull = 0
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // Host
    input  wire logic palette_write_i,
    input  wire logic [voxel_pkg::VoxelPaletteBits-1:0] palette_index_i,
    input  wire logic [voxel_pkg::VoxelColourBits-1:0] palette_colour_i,
    input  wire logic column_write_i,
    input  wire logic [voxel_pkg::VoxelColumnBits-1:0] column_address_i,
    input  wire logic [voxel_pkg::VoxelMemoryBits-1:0] column_data_i,
    input  wire logic build_i,
    input  wire logic [voxel_pkg::VoxelRectangleBits-1:0] rect_x_low_i,
    input  wire logic [voxel_pkg::VoxelRectangleBits-1:0] rect_y_low_i,
    input  wire logic [voxel_pkg::VoxelRectangleBits-1:0] rect_x_high_i,
    input  wire logic [voxel_pkg::VoxelRectangleBits-1:0] rect_y_high_i,
    output logic built_o,
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] origin_x_i,  // signed
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] origin_y_i,
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] origin_z_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] d00_x_i,  // signed 2.24
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] d00_y_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] d00_z_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] dx_x_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] dx_y_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] dx_z_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] dy_x_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] dy_y_i,
    input  wire logic [voxel_pkg::VoxelCameraBits-1:0] dy_z_i,
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] light_x_i,  // signed
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] light_y_i,
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] light_z_i,
    input  wire logic start_i,
    output logic picture_done_o,
    // column_memory
    output logic column_read_o,
    output logic column_write_o,
    output logic [voxel_pkg::VoxelColumnBits-1:0] column_address_o,
    output logic [voxel_pkg::VoxelMemoryBits-1:0] column_data_o,
    input  wire logic [voxel_pkg::VoxelMemoryBits-1:0] column_word_i,
    // occupancy_memory
    output logic occupancy_read_o,
    output logic occupancy_write_o,
    output logic [voxel_pkg::VoxelWordBits-1:0] occupancy_address_o,
    output logic [voxel_pkg::VoxelMemoryBits-1:0] occupancy_data_o,
    input  wire logic [voxel_pkg::VoxelMemoryBits-1:0] occupancy_word_i,
    // frame_memory
    output logic mem_write_o,
    output logic [19:0] mem_address_o,
    output logic [63:0] mem_data_o,
    input  wire logic [63:0] mem_data_i,
    // Monitor
    output logic hsync_no,
    output logic vsync_no,
    output logic [9:0] red_o,
    output logic [9:0] green_o,
    output logic [9:0] blue_o
);
  /* verilator lint_off UNUSEDSIGNAL */  // some are for monitors and counters
  // voxel_builder
  wire logic [31:0] columns;
  wire logic [voxel_pkg::VoxelBuilderStateBits-1:0] builder_state;
  // voxel_scan
  wire logic camera_start, next_pixel, next_line, start, shadow;
  wire logic [voxel_pkg::VoxelLimitBits-1:0] max_outer, max_inner;
  wire logic take, shade, shadowed, put_valid;
  wire logic [19:0] put_address;
  wire logic [63:0] put_data;
  wire logic [voxel_pkg::VoxelScanStateBits-1:0] scan_state;
  // voxel_camera
  wire logic [voxel_pkg::VoxelDirectionBits-1:0] direction_x, direction_y, direction_z;
  // voxel_walker
  wire logic setup;
  wire logic [voxel_pkg::VoxelDirectionBits-1:0] ray_x, ray_y, ray_z;
  wire logic [voxel_pkg::VoxelPositionBits-1:0] from_x, from_y, from_z;
  wire logic [voxel_pkg::VoxelCoordinateBits-1:0] voxel_x, voxel_y, voxel_z;
  wire logic [voxel_pkg::VoxelLevelBits-1:0] level;
  wire logic walk_read, leaf, at, column;
  wire logic [voxel_pkg::VoxelTBits-1:0] t, t_out, step;
  wire logic outer, inner, ray_done;
  wire logic [voxel_pkg::VoxelKindBits-1:0] kind;
  wire logic [voxel_pkg::VoxelPositionBits-1:0] hit_x, hit_y, hit_z;
  wire logic [voxel_pkg::VoxelStateBits-1:0] walker_state;
  // voxel_setup
  wire logic [voxel_pkg::VoxelInverseBits-1:0] inverse_x, inverse_y, inverse_z;
  wire logic [2:0] parallel;
  wire logic setup_done;
  // voxel_limits
  wire logic reached;
  // voxel_address
  wire logic [voxel_pkg::VoxelWordBits-1:0] word;
  wire logic [voxel_pkg::VoxelBitBits-1:0] bit_number;
  wire logic is_inside;
  // voxel_leaf
  wire logic leaf_read;
  wire logic [voxel_pkg::VoxelColumnBits-1:0] leaf_address;
  wire logic some, sample, leaf_hit, leaf_done;
  wire logic [voxel_pkg::VoxelTBits-1:0] leaf_t;
  wire logic [voxel_pkg::VoxelSampleBits-1:0] samples;
  wire logic [voxel_pkg::VoxelPositionBits-1:0] position_x, position_y, position_z;
  // voxel_shade
  wire logic shade_read;
  wire logic [voxel_pkg::VoxelColumnBits-1:0] shade_address;
  wire logic shade_done;
  wire logic [voxel_pkg::VoxelColourBits-1:0] colour;
  // frame_store
  wire logic put_ready;
  /* verilator lint_on UNUSEDSIGNAL */

  assign column_data_o = column_data_i;

  voxel_builder #(
      .SizeX(SizeX),
      .SizeY(SizeY),
      .SizeZ(SizeZ),
      .VoxelX(VoxelX),
      .VoxelY(VoxelY),
      .VoxelZ(VoxelZ),
      .Levels(Levels),
      .MemoryClocks(MemoryClocks)
  ) u_voxel_builder (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .rect_x_low_i(rect_x_low_i),
      .rect_y_low_i(rect_y_low_i),
      .rect_x_high_i(rect_x_high_i),
      .rect_y_high_i(rect_y_high_i),
      .start_i(build_i),
      .host_write_i(column_write_i),
      .host_address_i(column_address_i),
      .done_o(built_o),
      .walk_read_i(walk_read),
      .walk_address_i(word),
      .leaf_read_i(shade_read),
      .leaf_address_i(shade_address),
      .column_read_o(column_read_o),
      .column_write_o(column_write_o),
      .column_address_o(column_address_o),
      .column_data_i(column_word_i),
      .occupancy_read_o(occupancy_read_o),
      .occupancy_write_o(occupancy_write_o),
      .occupancy_address_o(occupancy_address_o),
      .occupancy_data_o(occupancy_data_o),
      .occupancy_data_i(occupancy_word_i),
      .columns_o(columns),
      .state_o(builder_state)
  );

  voxel_scan #(
      .PictureWidth(PictureWidth),
      .PictureHeight(PictureHeight),
      .MaxOuter(MaxOuter),
      .MaxInner(MaxInner),
      .Shadows(Shadows),
      .ShadowOuter(ShadowOuter),
      .ShadowInner(ShadowInner)
  ) u_voxel_scan (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .start_i(start_i),
      .picture_done_o(picture_done_o),
      .camera_start_o(camera_start),
      .next_pixel_o(next_pixel),
      .next_line_o(next_line),
      .start_o(start),
      .shadow_o(shadow),
      .ray_done_i(ray_done),
      .kind_i(kind),
      .max_outer_o(max_outer),
      .max_inner_o(max_inner),
      .take_o(take),
      .shade_o(shade),
      .shadowed_o(shadowed),
      .done_i(shade_done),
      .colour_i(colour),
      .put_valid_o(put_valid),
      .put_address_o(put_address),
      .put_data_o(put_data),
      .put_ready_i(put_ready),
      .state_o(scan_state)
  );

  voxel_camera u_voxel_camera (
      .clk_i(clk_i),
      .d00_x_i(d00_x_i),
      .d00_y_i(d00_y_i),
      .d00_z_i(d00_z_i),
      .dx_x_i(dx_x_i),
      .dx_y_i(dx_y_i),
      .dx_z_i(dx_z_i),
      .dy_x_i(dy_x_i),
      .dy_y_i(dy_y_i),
      .dy_z_i(dy_z_i),
      .start_i(camera_start),
      .next_pixel_i(next_pixel),
      .next_line_i(next_line),
      .direction_x_o(direction_x),
      .direction_y_o(direction_y),
      .direction_z_o(direction_z)
  );

  voxel_walker #(
      .SizeZ(SizeZ),
      .VoxelX(VoxelX),
      .VoxelY(VoxelY),
      .VoxelZ(VoxelZ),
      .Levels(Levels),
      .Leaf(Leaf),
      .LeafSteps(LeafSteps),
      .Raise(Raise),
      .GroupFetch(GroupFetch),
      .MemoryClocks(MemoryClocks)
  ) u_voxel_walker (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .start_i(start),
      .shadow_i(shadow),
      .origin_x_i(origin_x_i),
      .origin_y_i(origin_y_i),
      .origin_z_i(origin_z_i),
      .light_x_i(light_x_i),
      .light_y_i(light_y_i),
      .light_z_i(light_z_i),
      .direction_x_i(direction_x),
      .direction_y_i(direction_y),
      .direction_z_i(direction_z),
      .setup_o(setup),
      .inverse_x_i(inverse_x),
      .inverse_y_i(inverse_y),
      .inverse_z_i(inverse_z),
      .ray_x_o(ray_x),
      .ray_y_o(ray_y),
      .ray_z_o(ray_z),
      .from_x_o(from_x),
      .from_y_o(from_y),
      .from_z_o(from_z),
      .x_o(voxel_x),
      .y_o(voxel_y),
      .z_o(voxel_z),
      .level_o(level),
      .inside_i(is_inside),
      .bit_i(bit_number),
      .read_o(walk_read),
      .data_i(occupancy_word_i),
      .leaf_o(leaf),
      .at_o(at),
      .column_o(column),
      .t_o(t),
      .t_out_o(t_out),
      .step_o(step),
      .some_i(some),
      .sample_i(sample),
      .hit_i(leaf_hit),
      .done_i(leaf_done),
      .position_x_i(position_x),
      .position_y_i(position_y),
      .position_z_i(position_z),
      .outer_o(outer),
      .inner_o(inner),
      .reached_i(reached),
      .ray_done_o(ray_done),
      .kind_o(kind),
      .hit_x_o(hit_x),
      .hit_y_o(hit_y),
      .hit_z_o(hit_z),
      .state_o(walker_state)
  );

  voxel_setup u_voxel_setup (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .start_i(setup),
      .direction_x_i(ray_x),
      .direction_y_i(ray_y),
      .direction_z_i(ray_z),
      .inverse_x_o(inverse_x),
      .inverse_y_o(inverse_y),
      .inverse_z_o(inverse_z),
      .parallel_o(parallel),
      .done_o(setup_done)
  );

  voxel_limits u_voxel_limits (
      .clk_i(clk_i),
      .start_i(start),
      .outer_i(outer),
      .inner_i(inner),
      .max_outer_i(max_outer),
      .max_inner_i(max_inner),
      .reached_o(reached)
  );

  voxel_address #(
      .SizeX(SizeX),
      .SizeY(SizeY),
      .SizeZ(SizeZ),
      .VoxelX(VoxelX),
      .VoxelY(VoxelY),
      .VoxelZ(VoxelZ),
      .Levels(Levels)
  ) u_voxel_address (
      .x_i(voxel_x),
      .y_i(voxel_y),
      .z_i(voxel_z),
      .level_i(level),
      .word_o(word),
      .bit_o(bit_number),
      .inside_o(is_inside)
  );

  voxel_leaf #(
      .SizeX(SizeX),
      .SizeY(SizeY),
      .MemoryClocks(MemoryClocks)
  ) u_voxel_leaf (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .start_i(leaf),
      .at_i(at),
      .fetch_i(column),
      .t_from_i(t),
      .t_to_i(t_out),
      .step_i(step),
      .origin_x_i(from_x),
      .origin_y_i(from_y),
      .origin_z_i(from_z),
      .direction_x_i(ray_x),
      .direction_y_i(ray_y),
      .direction_z_i(ray_z),
      .stop_i(reached),
      .data_i(column_word_i),
      .read_o(leaf_read),
      .address_o(leaf_address),
      .some_o(some),
      .sample_o(sample),
      .hit_o(leaf_hit),
      .done_o(leaf_done),
      .t_o(leaf_t),
      .samples_o(samples),
      .position_x_o(position_x),
      .position_y_o(position_y),
      .position_z_o(position_z)
  );

  voxel_shade #(
      .Leaf(Leaf),
      .Shading(Shading),
      .Sky(Sky),
      .DebugLimits(DebugLimits),
      .MemoryClocks(MemoryClocks),
      .SizeX(SizeX),
      .SizeY(SizeY),
      .SizeZ(SizeZ)
  ) u_voxel_shade (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .palette_write_i(palette_write_i),
      .palette_index_i(palette_index_i),
      .palette_colour_i(palette_colour_i),
      .take_i(take),
      .shade_i(shade),
      .shadowed_i(shadowed),
      .kind_i(kind),
      .hit_x_i(hit_x),
      .hit_y_i(hit_y),
      .hit_z_i(hit_z),
      .direction_z_i(direction_z),
      .leaf_read_i(leaf_read),
      .leaf_address_i(leaf_address),
      .read_o(shade_read),
      .address_o(shade_address),
      .data_i(column_word_i),
      .done_o(shade_done),
      .colour_o(colour),
      .put_ready_i(put_ready)
  );

  frame_store #(
      .ClocksPerPixel(2),
      .WriteBufferDepth(WriteBufferDepth),
      .WritePolicy(WritePolicy),
      .WhenFull(WhenFull),
      .StoreFormat(1),
      .PictureWidth(PictureWidth),
      .PictureHeight(PictureHeight),
      .AddressBits(19),
      .DataBits(24)
  ) u_frame_store (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .put_rst_ni(rst_ni),
      .put_valid_i(put_valid),
      .put_address_i(put_address),
      .put_data_i(put_data),
      .put_ready_o(put_ready),
      .mem_write_o(mem_write_o),
      .mem_address_o(mem_address_o),
      .mem_data_o(mem_data_o),
      .mem_data_i(mem_data_i),
      .hsync_no(hsync_no),
      .vsync_no(vsync_no),
      .red_o(red_o),
      .green_o(green_o),
      .blue_o(blue_o)
  );
endmodule

`default_nettype wire
