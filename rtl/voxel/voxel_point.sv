// voxel_point: one axis of where a ray is: origin + t * direction, rounded down.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_point (
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] origin_i,  // signed
    input  wire logic [voxel_pkg::VoxelTBits-1:0] t_i,
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] direction_i,  // signed
    output logic [voxel_pkg::VoxelPositionBits-1:0] position_o  // signed
);
  localparam int ProductBits = voxel_pkg::VoxelTBits + 1 + voxel_pkg::VoxelDirectionBits;

  wire logic signed [voxel_pkg::VoxelTBits:0] t = {1'b0, t_i};
  wire logic signed [voxel_pkg::VoxelDirectionBits-1:0] direction = direction_i;
  /* verilator lint_off UNUSEDSIGNAL */  // it is rounded, and the world repeats
  wire logic signed [ProductBits-1:0] moved = t * direction;
  /* verilator lint_on UNUSEDSIGNAL */

  assign position_o = origin_i
      + moved[voxel_pkg::VoxelDirectionFraction+:voxel_pkg::VoxelPositionBits];
endmodule

`default_nettype wire
