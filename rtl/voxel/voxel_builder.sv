// voxel_builder: builds the octree of occupancy; between the memories and who else reads them.
// Contract: sc/voxel/voxel_builder.h
//
// All parts share the walk over z, x and y, and the access of 1 + MemoryClocks clocks. Only the
// state and columns_o are reset: a build begins with fresh places.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_builder #(
    parameter int SizeX = 64,
    parameter int SizeY = 64,
    parameter int SizeZ = 32,
    parameter int VoxelX = 1,
    parameter int VoxelY = 4,
    parameter int VoxelZ = 1,
    parameter int Levels = 5,
    parameter int MemoryClocks = 1
) (
    // Clock and reset
    input  wire logic clk_i,
    input  wire logic rst_ni,
    // Host
    input  wire logic [voxel_pkg::VoxelRectangleBits-1:0] rect_x_low_i,  // columns
    input  wire logic [voxel_pkg::VoxelRectangleBits-1:0] rect_y_low_i,
    input  wire logic [voxel_pkg::VoxelRectangleBits-1:0] rect_x_high_i,  // not included
    input  wire logic [voxel_pkg::VoxelRectangleBits-1:0] rect_y_high_i,
    input  wire logic start_i,
    input  wire logic host_write_i,
    input  wire logic [voxel_pkg::VoxelColumnBits-1:0] host_address_i,
    output logic done_o,
    // voxel_walker, voxel_address
    input  wire logic walk_read_i,
    input  wire logic [voxel_pkg::VoxelWordBits-1:0] walk_address_i,
    // voxel_leaf, voxel_shade
    input  wire logic leaf_read_i,
    input  wire logic [voxel_pkg::VoxelColumnBits-1:0] leaf_address_i,
    // column_memory; what is written there is the host's
    output logic column_read_o,
    output logic column_write_o,
    output logic [voxel_pkg::VoxelColumnBits-1:0] column_address_o,
    /* verilator lint_off UNUSEDSIGNAL */  // materials
    input  wire logic [voxel_pkg::VoxelMemoryBits-1:0] column_data_i,
    /* verilator lint_on UNUSEDSIGNAL */
    // occupancy_memory
    output logic occupancy_read_o,
    output logic occupancy_write_o,
    output logic [voxel_pkg::VoxelWordBits-1:0] occupancy_address_o,
    output logic [voxel_pkg::VoxelMemoryBits-1:0] occupancy_data_o,
    input  wire logic [voxel_pkg::VoxelMemoryBits-1:0] occupancy_data_i,
    // For counters
    output logic [31:0] columns_o,
    output logic [voxel_pkg::VoxelBuilderStateBits-1:0] state_o  // voxel_builder_state
);
  localparam int Bits = voxel_pkg::VoxelRectangleBits;
  localparam int HeightBits = voxel_pkg::VoxelHeightBits;
  localparam int CoordinateBits = voxel_pkg::VoxelCoordinateBits;
  localparam int LevelBits = voxel_pkg::VoxelLevelBits;
  localparam int ColumnBits = voxel_pkg::VoxelColumnBits;
  localparam int BitsX = $clog2(VoxelX);
  localparam int BitsY = $clog2(VoxelY);
  localparam int BitsZ = $clog2(VoxelZ);
  localparam int CountBits = $clog2(SizeX * SizeY + 1);  // of columns
  localparam logic [LevelBits-1:0] TopLevel = LevelBits'(Levels - 1);

  typedef logic [Bits-1:0] place;

  voxel_pkg::voxel_builder_state state_q, state_d;
  logic known_q, known_d;  // FILL: the column is there
  logic puts_q, puts_d;  // a bit is read to be written
  logic [3:0] phase_q, phase_d;  // clocks of an access that are over
  logic [LevelBits-1:0] level_q, level_d;
  place x_low_q, x_low_d, y_low_q, y_low_d;  // in voxels of the level
  place x_high_q, x_high_d, y_high_q, y_high_d;
  place x_q, x_d, y_q, y_d;  // the voxel; in FILL the column
  logic [HeightBits-1:0] z_q, z_d;
  logic [2:0] child_q, child_d;  // UP: that is looked at
  logic found_q, found_d;  // and the last one was occupied
  logic [HeightBits-1:0] low_q, low_d, middle_q, middle_d, high_q, high_d;
  logic [CountBits-1:0] columns_q, columns_d;

  wire logic idle = state_q == voxel_pkg::VoxelBuilderIdle;
  wire logic fills = state_q == voxel_pkg::VoxelBuilderFill;
  wire logic ups = state_q == voxel_pkg::VoxelBuilderUp;

  // --- What is done in this clock ----------------------------------------------------------------
  wire logic fetches = fills && !known_q;
  wire logic compares = fills && known_q && !puts_q;
  wire logic looks = ups && !puts_q;
  wire logic over = phase_q == 4'(MemoryClocks);  // the last clock of an access
  wire logic takes = idle && start_i && rect_x_low_i < rect_x_high_i
      && rect_y_low_i < rect_y_high_i && 32'(rect_x_high_i) <= SizeX && 32'(rect_y_high_i) <= SizeY;

  wire logic [8:0] from = 9'(z_q) << BitsZ;
  wire logic [8:0] to = from + 9'(VoxelZ);
  wire logic solid = from < 9'(low_q)
      || middle_q < high_q && to > 9'(middle_q) && from < 9'(high_q);
  wire logic leaves = compares ? !solid : puts_q && over;

  // --- Where it is -------------------------------------------------------------------------------
  wire place x_begin = fills ? x_low_q << BitsX : x_low_q;
  wire place x_end = fills ? x_high_q << BitsX : x_high_q;
  wire place y_end = fills ? y_high_q << BitsY : y_high_q;
  logic [HeightBits-1:0] z_top;
  always_comb begin
    z_top = '0;
    for (int k = 0; k < Levels; k++)
      if (k == 0 || level_q == LevelBits'(k)) z_top = HeightBits'((SizeZ / VoxelZ >> k) - 1);
  end
  wire logic top = z_q == z_top;
  wire logic row = x_q == x_end - 1'b1;
  wire logic last = top && row && y_q == y_end - 1'b1;
  wire logic tops = fills ? Levels == 1 : ups && level_q == TopLevel;  // the last part of a build

  // --- Memories ----------------------------------------------------------------------------------
  wire logic [CoordinateBits-1:0] voxel_x = CoordinateBits'(x_q);
  wire logic [CoordinateBits-1:0] voxel_y = CoordinateBits'(y_q);
  wire logic [CoordinateBits-1:0] voxel_z = CoordinateBits'(z_q);
  wire logic [voxel_pkg::VoxelWordBits-1:0] word;
  wire logic [voxel_pkg::VoxelBitBits-1:0] number;
  voxel_address #(
      .SizeX(SizeX),
      .SizeY(SizeY),
      .SizeZ(SizeZ),
      .VoxelX(VoxelX),
      .VoxelY(VoxelY),
      .VoxelZ(VoxelZ),
      .Levels(Levels)
  ) u_voxel_address (
      .x_i(fills ? voxel_x >> BitsX : looks ? {voxel_x[CoordinateBits-2:0], child_q[0]} : voxel_x),
      .y_i(fills ? voxel_y >> BitsY : looks ? {voxel_y[CoordinateBits-2:0], child_q[1]} : voxel_y),
      .z_i(looks ? {voxel_z[CoordinateBits-2:0], child_q[2]} : voxel_z),
      .level_i(looks ? level_q - 1'b1 : level_q),
      .word_o(word),
      .bit_o(number),
      /* verilator lint_off PINCONNECTEMPTY */
      .inside_o()  // it is always
      /* verilator lint_on PINCONNECTEMPTY */
  );
  wire logic [voxel_pkg::VoxelMemoryBits-1:0] own = voxel_pkg::VoxelMemoryBits'(1) << number;

  always_comb begin
    column_read_o = fetches && phase_q == '0;
    column_write_o = 1'b0;
    column_address_o = ColumnBits'(y_q) * ColumnBits'(SizeX) + ColumnBits'(x_q);
    occupancy_read_o = (puts_q || looks) && phase_q == '0;
    occupancy_write_o = puts_q && over;
    occupancy_address_o = word;
    occupancy_data_o = fills || ups && found_q ? occupancy_data_i | own : occupancy_data_i & ~own;
    if (idle) begin
      column_read_o = leaf_read_i && !host_write_i;
      column_write_o = host_write_i;
      column_address_o = host_write_i ? host_address_i : leaf_address_i;
      occupancy_read_o = walk_read_i;
      occupancy_write_o = 1'b0;
      occupancy_address_o = walk_address_i;
      occupancy_data_o = '0;
    end
  end

  // --- Next ----------------------------------------------------------------------------------------
  always_comb begin
    {state_d, known_d, puts_d, level_d} = {state_q, known_q, puts_q, level_q};
    {x_low_d, y_low_d, x_high_d, y_high_d} = {x_low_q, y_low_q, x_high_q, y_high_q};
    {x_d, y_d, z_d, child_d, found_d} = {x_q, y_q, z_q, child_q, found_q};
    {low_d, middle_d, high_d, columns_d} = {low_q, middle_q, high_q, columns_q};
    phase_d = idle || compares || over ? '0 : phase_q + 1'b1;
    if (takes) begin
      state_d = voxel_pkg::VoxelBuilderClear;
      {known_d, puts_d, level_d, z_d, child_d, found_d, columns_d} = '0;
      puts_d = 1'b1;
      x_low_d = rect_x_low_i >> BitsX;
      y_low_d = rect_y_low_i >> BitsY;
      x_high_d = (rect_x_high_i + Bits'(VoxelX - 1)) >> BitsX;
      y_high_d = (rect_y_high_i + Bits'(VoxelY - 1)) >> BitsY;
      {x_d, y_d} = {x_low_d, y_low_d};
    end else if (fetches && over) begin
      {high_d, middle_d, low_d} = column_data_i[3*HeightBits-1:0];
      known_d = 1'b1;
    end else if (looks && over) begin
      found_d = occupancy_data_i[number];
      puts_d = found_d || child_q == '1;
      child_d = puts_d ? '0 : child_q + 1'b1;
    end else if (leaves && !idle) begin
      known_d = fills && !top;
      puts_d = state_q == voxel_pkg::VoxelBuilderClear;
      if (fills && top) columns_d = columns_q + 1'b1;
      z_d = top ? '0 : z_q + 1'b1;
      if (!last) begin
        if (top) x_d = row ? x_begin : x_q + 1'b1;
        if (top && row) y_d = y_q + 1'b1;
      end else if (tops) state_d = voxel_pkg::VoxelBuilderIdle;
      else if (state_q == voxel_pkg::VoxelBuilderClear) begin
        state_d = voxel_pkg::VoxelBuilderFill;
        puts_d = 1'b0;
        {x_d, y_d} = {x_low_q << BitsX, y_low_q << BitsY};
      end else begin
        state_d = voxel_pkg::VoxelBuilderUp;
        level_d = level_q + 1'b1;
        {x_low_d, y_low_d} = {x_low_q >> 1, y_low_q >> 1};
        x_high_d = (x_high_q + 1'b1) >> 1;
        y_high_d = (y_high_q + 1'b1) >> 1;
        {x_d, y_d} = {x_low_d, y_low_d};
      end
    end else if (compares) puts_d = 1'b1;
  end

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      state_q <= voxel_pkg::VoxelBuilderIdle;
      columns_q <= '0;
    end else begin
      state_q <= state_d;
      columns_q <= columns_d;
    end
    {known_q, puts_q, phase_q, level_q} <= {known_d, puts_d, phase_d, level_d};
    {x_low_q, y_low_q, x_high_q, y_high_q} <= {x_low_d, y_low_d, x_high_d, y_high_d};
    {x_q, y_q, z_q, child_q, found_q} <= {x_d, y_d, z_d, child_d, found_d};
    {low_q, middle_q, high_q} <= {low_d, middle_d, high_d};
  end

  assign done_o = idle || tops && last && leaves;
  assign columns_o = 32'(columns_q);
  assign state_o = state_q;

`ifndef SYNTHESIS
  always_ff @(posedge clk_i)
    if (rst_ni && !idle) begin
      state_is_known : assert (state_q <= voxel_pkg::VoxelBuilderUp);
      level_is_known : assert (level_q <= TopLevel && ups == (level_q != '0));
      x_is_in_the_world :
        assert (x_low_q < x_high_q && 32'(x_high_q) <= (SizeX + VoxelX - 1) / VoxelX);
      y_is_in_the_world :
        assert (y_low_q < y_high_q && 32'(y_high_q) <= (SizeY + VoxelY - 1) / VoxelY);
      x_is_in_the_rectangle : assert (x_begin <= x_q && x_q < x_end && 32'(x_q) < SizeX);
      y_is_in_the_rectangle : assert (y_q < y_end && 32'(y_q) < SizeY);
      z_is_in_the_world : assert (z_q <= z_top);
      no_column_is_there_yet : assert (state_q != voxel_pkg::VoxelBuilderClear || columns_q == '0);
      columns_are_those_before : assert (!fills || 32'(columns_q) <= 32'(y_q) * SizeX + 32'(x_q));
    end
  always_ff @(posedge clk_i)
    if (rst_ni) columns_are_in_the_world : assert (32'(columns_q) <= SizeX * SizeY);
`endif
endmodule

`default_nettype wire
