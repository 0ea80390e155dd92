// frame_store: a frame store between a tracer and a monitor: raster, write buffer, arbiter and the
// beam's side, wired. The frame memory is outside.
// Contract: the headers of the units; the wires are those of sc/store/picture_chip.h.
//
// No arithmetic: a wire has the name of the port that drives it, without its suffix. The write
// buffer follows put_rst_ni, the raster and the beam's side rst_ni.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module frame_store #(
    parameter int ClocksPerPixel = 2,
    parameter int WriteBufferDepth = 64,
    parameter int WritePolicy = 0,
    parameter int WhenFull = 0,
    parameter int WrapRight = 0,
    parameter int StoreFormat = 0,
    parameter int ColourBits = 5,
    parameter int PictureWidth = 512,
    parameter int PictureHeight = 480,
    parameter int AddressBits = 18,
    parameter int DataBits = 16
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // Tracer
    input  wire logic put_rst_ni,
    input  wire logic put_valid_i,
    input  wire logic [19:0] put_address_i,
    input  wire logic [63:0] put_data_i,
    output logic put_ready_o,
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
  // vga_timing
  wire logic hsync_n, vsync_n, active, h_active, consume, line_end, active_start, frame_end;
  wire logic nav_line;
  wire logic [10:0] x2;
  wire logic [9:0] y;
  // write_buffer
  wire logic take_valid;
  wire logic [19:0] take_address;
  wire logic [63:0] take_data;
  wire logic [7:0] fill;
  // store_arbiter
  wire logic take_ready;
  // frame_scanout
  wire logic read;
  wire logic [19:0] read_address;
  /* verilator lint_on UNUSEDSIGNAL */

  wire logic sync = !hsync_n || !vsync_n;
  wire logic blank = !active;

  vga_timing #(
      .ClocksPerPixel(ClocksPerPixel)
  ) u_vga_timing (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .speed_i(3'd0),
      .hsync_no(hsync_n),
      .vsync_no(vsync_n),
      .x2_o(x2),
      .y_o(y),
      .active_o(active),
      .h_active_o(h_active),
      .consume_o(consume),
      .line_end_o(line_end),
      .active_start_o(active_start),
      .frame_end_o(frame_end),
      .nav_line_o(nav_line)
  );

  write_buffer #(
      .WriteBufferDepth(WriteBufferDepth),
      .WhenFull(WhenFull),
      .AddressBits(AddressBits),
      .DataBits(DataBits)
  ) u_write_buffer (
      .clk_i(clk_i),
      .rst_ni(put_rst_ni),
      .put_valid_i(put_valid_i),
      .put_address_i(put_address_i),
      .put_data_i(put_data_i),
      .put_ready_o(put_ready_o),
      .take_valid_o(take_valid),
      .take_address_o(take_address),
      .take_data_o(take_data),
      .take_ready_i(take_ready),
      .fill_o(fill)
  );

  store_arbiter #(
      .WritePolicy(WritePolicy)
  ) u_store_arbiter (
      .read_i(read),
      .read_address_i(read_address),
      .sync_i(sync),
      .blank_i(blank),
      .take_valid_i(take_valid),
      .take_address_i(take_address),
      .take_data_i(take_data),
      .take_ready_o(take_ready),
      .mem_write_o(mem_write_o),
      .mem_address_o(mem_address_o),
      .mem_data_o(mem_data_o)
  );

  frame_scanout #(
      .StoreFormat(StoreFormat),
      .ColourBits(ColourBits),
      .PictureWidth(PictureWidth),
      .PictureHeight(PictureHeight),
      .WrapRight(WrapRight)
  ) u_frame_scanout (
      .clk_i(clk_i),
      .rst_ni(rst_ni),
      .consume_i(consume),
      .active_i(active),
      .line_end_i(line_end),
      .y_i(y),
      .hsync_ni(hsync_n),
      .vsync_ni(vsync_n),
      .read_o(read),
      .read_address_o(read_address),
      .mem_data_i(mem_data_i),
      .red_o(red_o),
      .green_o(green_o),
      .blue_o(blue_o),
      .hsync_no(hsync_no),
      .vsync_no(vsync_no)
  );
endmodule

`default_nettype wire
