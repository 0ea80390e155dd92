// block_top: all units of the block renderer wired under one clock; the frame memory is outside.
// Contract: sc/block/block_chip.h, whose wires these are.
//
// No arithmetic: a wire has the name of the port that drives it, without its suffix, but for
// event_told. Those of all cores stand in one word, core 0 at the bottom. The raster's beam shows pictures of 640 columns at
// most; larger ones are for the memory alone.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module block_top #(
    parameter int Cores = 4,
    parameter int Lanes = 4,
    parameter int NewtonSteps = 2,
    parameter int SpecularSquarings = 4,
    parameter int MaxPasses = 3,
    parameter int Root = 0,
    parameter int ShadowRays = 0,
    parameter int Cull = 0,
    parameter int Background = 0,
    parameter int FractionBits = 20,
    parameter int PictureWidth = 640,
    parameter int PictureHeight = 480,
    parameter int WriteBufferDepth = 64,
    parameter int WritePolicy = 2,
    parameter int WhenFull = 0
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // Host
    input  wire logic valid_i,
    input  wire logic [31:0] float_i,
    input  wire logic [block_pkg::BlockFieldBits-1:0] field_i,  // block_field
    input  wire logic [block_pkg::BlockIndexBits-1:0] index_i,
    output logic ready_o,
    input  wire logic [block_pkg::BlockCountBits-1:0] spheres_i,
    input  wire logic [block_pkg::BlockBits-1:0] ax_i,
    input  wire logic [block_pkg::BlockBits-1:0] ay_i,
    input  wire logic [block_pkg::BlockBits-1:0] cone_sine_i,
    input  wire logic [block_pkg::BlockBits-1:0] cone_cosine2_i,
    input  wire logic start_i,
    output logic done_o,
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
  localparam int Bits = block_pkg::BlockBits;
  localparam int PlaceBits = block_pkg::BlockPlaceBits;
  localparam int AllCores = block_pkg::BlockCores;

  /* verilator lint_off UNUSEDSIGNAL */  // some are for monitors and counters
  // block_convert
  wire logic write;
  wire logic [block_pkg::BlockFieldBits-1:0] field;
  wire logic [block_pkg::BlockIndexBits-1:0] index;
  wire logic [Bits-1:0] fixed, eye_k, eye_x, eye_y, eye_z, light_x, light_y, light_z;
  wire logic [Bits-1:0] start_x, start_y, start_z;
  // block_scheduler
  wire logic [AllCores-1:0] job_valid;
  wire logic [PlaceBits-1:0] job_x, job_y;
  // block_core
  wire logic [AllCores-1:0] job_ready, busy, word_valid;
  wire logic [Cores*20-1:0] word_address;
  wire logic [Cores*64-1:0] word;
  wire logic [Cores*block_pkg::BlockStateBits-1:0] state;
  wire logic [Cores*block_pkg::BlockEventBits-1:0] event_told;
  // block_bus
  wire logic [AllCores-1:0] word_ready;
  wire logic bus_valid;
  wire logic [block_pkg::BlockIndexBits-1:0] core;
  // frame_store
  wire logic put_ready;
  /* verilator lint_on UNUSEDSIGNAL */

  wire logic [19:0] put_address = word_address[32'(core)*20+:20];
  wire logic [63:0] put_data = word[32'(core)*64+:64];

  block_convert #(
      .FractionBits(FractionBits)
  ) u_block_convert (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .valid_i(valid_i),
      .float_i(float_i),
      .field_i(field_i),
      .index_i(index_i),
      .ready_o(ready_o),
      .write_o(write),
      .field_o(field),
      .index_o(index),
      .fixed_o(fixed),
      .eye_k_o(eye_k),
      .eye_x_o(eye_x),
      .eye_y_o(eye_y),
      .eye_z_o(eye_z),
      .light_x_o(light_x),
      .light_y_o(light_y),
      .light_z_o(light_z),
      .start_x_o(start_x),
      .start_y_o(start_y),
      .start_z_o(start_z)
  );

  block_scheduler #(
      .Cores(Cores)
  ) u_block_scheduler (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .start_i(start_i),
      .width_i(PlaceBits'(PictureWidth)),
      .height_i(PlaceBits'(PictureHeight)),
      .done_o(done_o),
      .job_valid_o(job_valid),
      .job_x_o(job_x),
      .job_y_o(job_y),
      .job_ready_i(job_ready),
      .busy_i(busy)
  );

  if (Cores < AllCores) begin : g_no_core
    assign job_ready[AllCores-1:Cores] = '0;
    assign busy[AllCores-1:Cores] = '0;
    assign word_valid[AllCores-1:Cores] = '0;
  end

  for (genvar n = 0; n < Cores; n++) begin : g_core
    block_core #(
        .Lanes(Lanes),
        .NewtonSteps(NewtonSteps),
        .SpecularSquarings(SpecularSquarings),
        .MaxPasses(MaxPasses),
        .Root(Root),
        .ShadowRays(ShadowRays),
        .Cull(Cull),
        .Background(Background),
        .PictureWidth(PictureWidth),
        .PictureHeight(PictureHeight)
    ) u_block_core (
        .clk_i(clk_i),
        .rst_ni(rst_ni),
        .job_valid_i(job_valid[n]),
        .job_x_i(job_x),
        .job_y_i(job_y),
        .job_ready_o(job_ready[n]),
        .busy_o(busy[n]),
        .write_i(write),
        .field_i(field),
        .index_i(index),
        .value_i(fixed),
        .eye_k_i(eye_k),
        .spheres_i(spheres_i),
        .eye_x_i(eye_x),
        .eye_y_i(eye_y),
        .eye_z_i(eye_z),
        .light_x_i(light_x),
        .light_y_i(light_y),
        .light_z_i(light_z),
        .start_x_i(start_x),
        .start_y_i(start_y),
        .start_z_i(start_z),
        .ax_i(ax_i),
        .ay_i(ay_i),
        .cone_sine_i(cone_sine_i),
        .cone_cosine2_i(cone_cosine2_i),
        .word_valid_o(word_valid[n]),
        .word_address_o(word_address[n*20+:20]),
        .word_o(word[n*64+:64]),
        .word_ready_i(word_ready[n]),
        .state_o(state[n*block_pkg::BlockStateBits+:block_pkg::BlockStateBits]),
        .event_o(event_told[n*block_pkg::BlockEventBits+:block_pkg::BlockEventBits])
    );
  end

  block_bus #(
      .Cores(Cores)
  ) u_block_bus (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .word_valid_i(word_valid),
      .word_ready_o(word_ready),
      .bus_valid_o(bus_valid),
      .core_o(core),
      .bus_ready_i(put_ready)
  );

  frame_store #(
      .ClocksPerPixel(2),
      .WriteBufferDepth(WriteBufferDepth),
      .WritePolicy(WritePolicy),
      .WhenFull(WhenFull),
      .StoreFormat(2),
      .PictureWidth(PictureWidth),
      .PictureHeight(PictureHeight),
      .AddressBits(20),
      .DataBits(64)
  ) u_frame_store (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .put_rst_ni(rst_ni),
      .put_valid_i(bus_valid),
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
