// voxel_limits: how far a ray may still go: voxels that it moves to, and samples without a hit.
// Contract: sc/voxel/voxel_limits.h
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_limits (
    // Clock
    input  wire logic clk_i,
    // voxel_walker
    input  wire logic start_i,  // a ray begins
    input  wire logic outer_i,  // it moves
    input  wire logic inner_i,  // a sample was no hit
    // voxel_scan
    input  wire logic [voxel_pkg::VoxelLimitBits-1:0] max_outer_i,
    input  wire logic [voxel_pkg::VoxelLimitBits-1:0] max_inner_i,
    // voxel_walker
    output logic reached_o
);
  localparam int Bits = voxel_pkg::VoxelLimitBits;
  typedef logic [Bits-1:0] count;

  count outer_q, inner_q;  // left

  always_ff @(posedge clk_i) begin
    if (start_i) {outer_q, inner_q} <= {max_outer_i, max_inner_i};
    else begin
      if (outer_i && outer_q != '0) outer_q <= outer_q - 1'b1;
      if (inner_i && inner_q != '0) inner_q <= inner_q - 1'b1;
    end
  end

  assign reached_o = outer_i && outer_q == '0 || inner_i && inner_q <= Bits'(1);
endmodule

`default_nettype wire
