// voxel_move: the voxel behind the border that voxel_walker leaves one by, of the same level or a
// higher one.
//
// A voxel's border is its parent's too if it is the parent's half on that side, which the lowest
// bit of its coordinate says.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_move #(
    parameter int SizeZ = 32,
    parameter int VoxelX = 1,
    parameter int VoxelY = 4,
    parameter int VoxelZ = 1,
    parameter int Levels = 5,
    parameter int Raise = 0  // 0: one, 1: all
) (
    input  wire logic [voxel_pkg::VoxelCoordinateBits-1:0] x_i,  // signed
    input  wire logic [voxel_pkg::VoxelCoordinateBits-1:0] y_i,
    input  wire logic [voxel_pkg::VoxelCoordinateBits-1:0] z_i,
    input  wire logic [voxel_pkg::VoxelLevelBits-1:0] level_i,
    input  wire logic [1:0] axis_i,
    input  wire logic plus_i,  // towards higher coordinates
    output logic [voxel_pkg::VoxelCoordinateBits-1:0] x_o,  // signed
    output logic [voxel_pkg::VoxelCoordinateBits-1:0] y_o,
    output logic [voxel_pkg::VoxelCoordinateBits-1:0] z_o,
    output logic [voxel_pkg::VoxelLevelBits-1:0] level_o,
    output logic above_o,  // the world
    output logic outside_o  // below it, or farther away than numbers go
);
  localparam int Bits = voxel_pkg::VoxelCoordinateBits;
  localparam int LevelBits = voxel_pkg::VoxelLevelBits;
  localparam int MostShift = 12;  // of a side: 16 * 2^8
  localparam int LowBits = Bits + 1 + MostShift;

  typedef logic signed [Bits-1:0] coordinate;

  wire coordinate x = x_i;
  wire coordinate y = y_i;
  wire coordinate z = z_i;
  coordinate along;
  logic [LevelBits-1:0] first;  // shift of a side at level 0
  always_comb
    case (axis_i)
      2'd0: {along, first} = {x, LevelBits'($clog2(VoxelX))};
      2'd1: {along, first} = {y, LevelBits'($clog2(VoxelY))};
      default: {along, first} = {z, LevelBits'($clog2(VoxelZ))};
    endcase

  // --- Levels up -------------------------------------------------------------------------------
  logic [LevelBits-1:0] up;
  always_comb begin
    up = '0;
    for (int n = 0; n < (Raise == 1 ? Levels - 1 : 1); n++)
      if (up == LevelBits'(n) && level_i + up + 1'b1 < LevelBits'(Levels) && along[n] == plus_i)
        up = LevelBits'(n + 1);
  end
  assign level_o = level_i + up;

  // --- A voxel on ------------------------------------------------------------------------------
  wire coordinate parent_x = x >>> up;
  wire coordinate parent_y = y >>> up;
  wire coordinate parent_z = z >>> up;
  wire coordinate parent = along >>> up;
  wire logic [Bits:0] moved = {parent[Bits-1], parent} + {{Bits{!plus_i}}, 1'b1};
  assign x_o = axis_i == 2'd0 ? moved[Bits-1:0] : parent_x;
  assign y_o = axis_i == 2'd1 ? moved[Bits-1:0] : parent_y;
  assign z_o = axis_i[1] ? moved[Bits-1:0] : parent_z;

  // --- Where that is ---------------------------------------------------------------------------
  wire logic [Bits:0] height = axis_i[1] ? moved : {parent_z[Bits-1], parent_z};
  wire logic [Bits:0] top = (Bits + 1)'(SizeZ / VoxelZ) >> level_o;
  assign above_o = !height[Bits] && height >= top;

  /* verilator lint_off UNUSEDSIGNAL */  // no more than the sign of it
  wire logic [LowBits-1:0] low = {{MostShift{moved[Bits]}}, moved} << (level_o + first);
  /* verilator lint_on UNUSEDSIGNAL */
  wire logic far_away = low[LowBits-1:Bits] != {(LowBits - Bits) {low[Bits-1]}};
  assign outside_o = height[Bits] || far_away;
endmodule

`default_nettype wire
