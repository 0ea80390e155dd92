// voxel_border: one axis of voxel_walker: t where the ray meets the border at a whole coordinate.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_border #(
    parameter int BorderBits = 17
) (
    input  wire logic [BorderBits-1:0] border_i,  // signed, in units
    input  wire logic [voxel_pkg::VoxelPositionBits-1:0] origin_i,  // signed
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] direction_i,  // signed
    input  wire logic [voxel_pkg::VoxelInverseBits-1:0] inverse_i,
    output logic [voxel_pkg::VoxelTBits-1:0] t_o,
    output logic parallel_o,  // never met
    output logic beyond_o  // the origin is at the border, or above it
);
  localparam int Bits = voxel_pkg::VoxelDirectionBits;
  localparam int TBits = voxel_pkg::VoxelTBits;
  localparam int DeltaBits = BorderBits + voxel_pkg::VoxelPositionFraction + 1;
  localparam int ProductBits = DeltaBits + voxel_pkg::VoxelInverseBits + 1;
  localparam int NeverBit = voxel_pkg::VoxelInverseFraction + TBits - 1;

  wire logic [Bits-1:0] size = direction_i[Bits-1] ? -direction_i : direction_i;
  assign parallel_o = size < Bits'(voxel_pkg::VoxelParallel);

  wire logic signed [DeltaBits-2:0] border = {border_i, {voxel_pkg::VoxelPositionFraction{1'b0}}};
  wire logic signed [voxel_pkg::VoxelPositionBits-1:0] origin = origin_i;
  wire logic signed [DeltaBits-1:0] ahead = DeltaBits'(border) - DeltaBits'(origin);
  assign beyond_o = ahead[DeltaBits-1] || ahead == '0;

  wire logic signed [DeltaBits-1:0] delta = direction_i[Bits-1] ? -ahead : ahead;
  wire logic signed [voxel_pkg::VoxelInverseBits:0] inverse = {1'b0, inverse_i};
  /* verilator lint_off UNUSEDSIGNAL */  // it is rounded down
  wire logic signed [ProductBits-1:0] product = delta * inverse;
  /* verilator lint_on UNUSEDSIGNAL */

  always_comb begin
    t_o = product[voxel_pkg::VoxelInverseFraction+:TBits];
    if (product[ProductBits-2:NeverBit] != '0) t_o = TBits'(1) << (TBits - 1);
    if (product[ProductBits-1]) t_o = '0;
    if (parallel_o) t_o = TBits'(1) << (TBits - 1);
  end
endmodule

`default_nettype wire
