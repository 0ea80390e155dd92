// voxel_step: what lies between samples of voxel_leaf: a unit along the longest axis, the smallest
// inverse, or a part of it.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_step #(
    parameter int LeafSteps = 1
) (
    input  wire logic [voxel_pkg::VoxelInverseBits-1:0] inverse_x_i,
    input  wire logic [voxel_pkg::VoxelInverseBits-1:0] inverse_y_i,
    input  wire logic [voxel_pkg::VoxelInverseBits-1:0] inverse_z_i,
    input  wire logic [2:0] parallel_i,  // z, y, x
    output logic [voxel_pkg::VoxelTBits-1:0] step_o
);
  localparam int Cut = voxel_pkg::VoxelInverseFraction - voxel_pkg::VoxelPositionFraction;
  localparam int TBits = voxel_pkg::VoxelTBits;
  localparam int RestBits = 4;  // of a division by 8 at most

  function automatic logic [TBits-1:0] smaller(
      input logic [TBits-1:0] value, input logic parallel,
      input logic [voxel_pkg::VoxelInverseBits-1:0] inverse);
    smaller = parallel || value < TBits'(inverse >> Cut) ? value : TBits'(inverse >> Cut);
  endfunction

  logic [TBits-1:0] unit;
  assign unit = smaller(
      smaller(smaller({TBits{1'b1}}, parallel_i[0], inverse_x_i), parallel_i[1], inverse_y_i),
      parallel_i[2], inverse_z_i);

  logic [RestBits-1:0] rest;
  always_comb begin
    rest = '0;
    for (int n = TBits - 1; n >= 0; n--) begin
      rest = {rest[RestBits-2:0], unit[n]};
      step_o[n] = rest >= RestBits'(LeafSteps);
      if (step_o[n]) rest = rest - RestBits'(LeafSteps);
    end
  end
endmodule

`default_nettype wire
