// frame_scanout: the beam's side of the frame store: reads words, shows their pixels.
// Contract: sc/store/frame_scanout.h
//
// Words on show and words from the memory are flip-flops without reset, as are the syncs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module frame_scanout #(
    parameter int StoreFormat = 0,  // 0: rgb_light, 1: rgb888, 2: planar
    parameter int ColourBits = 5,  // a channel, rgb_light only
    parameter int PictureWidth = 512,
    parameter int PictureHeight = 480,
    parameter int WrapRight = 0
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // vga_timing
    input  wire logic consume_i,  // last clock of a visible column
    input  wire logic active_i,  // visible pixel
    input  wire logic line_end_i,  // last clock of a line
    input  wire logic [9:0] y_i,  // signed, scan line, -273..251
    input  wire logic hsync_ni,
    input  wire logic vsync_ni,
    // store_arbiter, frame_memory
    output logic read_o,
    output logic [19:0] read_address_o,
    /* verilator lint_off UNUSEDSIGNAL */  // upper bits: as the format has them
    input  wire logic [63:0] mem_data_i,  // of the address in the clock before
    /* verilator lint_on UNUSEDSIGNAL */
    // Pins of the chip
    output logic [9:0] red_o,
    output logic [9:0] green_o,
    output logic [9:0] blue_o,
    output logic hsync_no,
    output logic vsync_no
);
  localparam int Planar = 2;
  localparam int GroupWords = StoreFormat == Planar ? 3 : 1;
  localparam int GroupBits = StoreFormat == Planar ? 3 : 0;  // of a column, within its group
  localparam int DataBits = StoreFormat == 0 ? 3 * ColourBits + 1 : StoreFormat == 1 ? 24 : 64;
  localparam int Waiting = GroupWords > 1 ? GroupWords - 1 : 1;

  typedef logic [DataBits-1:0] word;

  logic [9:0] column_q, column_d;
  logic first_q;  // an active clock is the first of its pixel
  logic [1:0] word_q, word_d;  // the word to be read now; 0: none, unless a group begins
  // What a clock of vga_timing asks for, the youngest first
  logic group_q[GroupWords], pixel_q[GroupWords], shown_q[GroupWords];
  logic hsync_q[GroupWords], vsync_q[GroupWords];
  word words_q[GroupWords];  // of the group on show
  /* verilator lint_off UNUSEDSIGNAL */  // with one word a group none waits
  word waiting_q[Waiting];  // from the memory, the youngest first
  /* verilator lint_on UNUSEDSIGNAL */

  // --- Reading ---------------------------------------------------------------------------------
  wire logic in_picture = WrapRight != 0 || 32'(column_q) < PictureWidth;
  wire logic pixel_begins = active_i && first_q;
  wire logic group_begins =
      pixel_begins && in_picture && 32'(column_q) % (1 << GroupBits) == 0;
  wire logic [1:0] plane = group_begins ? 2'd0 : word_q;
  /* verilator lint_off UNUSEDSIGNAL */  // the row has 9 bits
  wire logic [9:0] row = y_i + 10'd240;
  /* verilator lint_on UNUSEDSIGNAL */

  always_comb begin
    read_o = group_begins || word_q != '0;
    if (StoreFormat == Planar)
      read_address_o = 20'((32'(plane) * PictureHeight + 32'(row[8:0])) * (PictureWidth / 8)
                           + 32'(column_q[9:3]));
    else if (StoreFormat == 1 || PictureWidth > 512) read_address_o = 20'({row[8:0], column_q});
    else read_address_o = 20'({row[8:0], column_q[8:0]});
  end

  always_comb begin
    column_d = column_q;
    if (line_end_i) column_d = '0;
    else if (consume_i) column_d = column_q + 1'b1;
    word_d = '0;
    if (read_o && 32'(plane) != GroupWords - 1) word_d = plane + 1'b1;
  end

  // --- Words on show ---------------------------------------------------------------------------
  word on_show[GroupWords];

  always_comb begin
    for (int n = 0; n < GroupWords; n++) begin
      on_show[n] = words_q[n];
      if (group_q[GroupWords-1])
        on_show[n] = n == GroupWords - 1 ? mem_data_i[DataBits-1:0]
                                         : waiting_q[(GroupWords - 2 - n) % Waiting];
      else if (pixel_q[GroupWords-1]) on_show[n] = words_q[n] >> 8;
    end
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      column_q <= '0;
      first_q <= 1'b1;
      word_q <= '0;
    end else begin
      column_q <= column_d;
      first_q <= consume_i || !active_i;
      word_q <= word_d;
    end
    group_q[0] <= rst_ni && group_begins;
    pixel_q[0] <= rst_ni && pixel_begins;
    shown_q[0] <= rst_ni && active_i && in_picture;
    hsync_q[0] <= hsync_ni;
    vsync_q[0] <= vsync_ni;
    for (int n = 1; n < GroupWords; n++) begin
      group_q[n] <= rst_ni && group_q[n-1];
      pixel_q[n] <= rst_ni && pixel_q[n-1];
      shown_q[n] <= rst_ni && shown_q[n-1];
      hsync_q[n] <= hsync_q[n-1];
      vsync_q[n] <= vsync_q[n-1];
    end
    for (int n = 0; n < GroupWords; n++) words_q[n] <= on_show[n];
    waiting_q[0] <= mem_data_i[DataBits-1:0];
    for (int n = 1; n < Waiting; n++) waiting_q[n] <= waiting_q[n-1];
  end

  // --- Pins ------------------------------------------------------------------------------------
  logic [9:0] red, green, blue;
  generate
    if (StoreFormat == 0) begin : g_rgb_light
      localparam int Low = 10 - ColourBits;
      wire word shown = on_show[0];
      wire logic [Low-1:0] low = {Low{shown[3*ColourBits]}};
      assign red = {shown[2*ColourBits+:ColourBits], low};
      assign green = {shown[ColourBits+:ColourBits], low};
      assign blue = {shown[0+:ColourBits], low};
    end else begin : g_bytes
      wire logic [7:0] r = StoreFormat == 1 ? on_show[0][16+:8] : on_show[0][7:0];
      wire logic [7:0] g = StoreFormat == 1 ? on_show[0][8+:8] : on_show[1%GroupWords][7:0];
      wire logic [7:0] b = on_show[GroupWords-1][7:0];
      assign red = {r, r[7:6]};
      assign green = {g, g[7:6]};
      assign blue = {b, b[7:6]};
    end
  endgenerate
  wire logic visible = shown_q[GroupWords-1];
  assign red_o = visible ? red : '0;
  assign green_o = visible ? green : '0;
  assign blue_o = visible ? blue : '0;
  assign hsync_no = hsync_q[GroupWords-1];
  assign vsync_no = vsync_q[GroupWords-1];
endmodule

`default_nettype wire
