// voxel_divider: one axis of voxel_setup: 2^36 / |direction|, two bits a clock.
//
// The remainder is less than the divisor at the end of each step; but for the smallest divisor, 16,
// whose quotient has a bit too many: there it stays 16, and all bits are ones.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_divider (
    input  wire logic clk_i,
    input  wire logic first_i,  // the first of 16 clocks
    input  wire logic divides_i,
    input  wire logic [voxel_pkg::VoxelDirectionBits-1:0] direction_i,  // signed
    output logic [voxel_pkg::VoxelInverseBits-1:0] inverse_o,  // whole after the last one
    output logic parallel_o
);
  localparam int Bits = voxel_pkg::VoxelDirectionBits;
  localparam int InverseBits = voxel_pkg::VoxelInverseBits;
  localparam int DividendBits = 36;

  logic [Bits:0] remainder_q, remainder_d;
  logic [InverseBits-1:0] inverse_q;

  wire logic [Bits-1:0] divisor = direction_i[Bits-1] ? -direction_i : direction_i;
  logic [1:0] digits;
  always_comb begin
    remainder_d = first_i ? (Bits + 1)'(1 << (DividendBits - InverseBits)) : remainder_q;
    for (int n = 1; n >= 0; n--) begin
      remainder_d = {remainder_d[Bits-1:0], 1'b0};
      digits[n] = remainder_d >= {1'b0, divisor};
      if (digits[n]) remainder_d = remainder_d - {1'b0, divisor};
    end
  end

  always_ff @(posedge clk_i)
    if (divides_i) begin
      remainder_q <= remainder_d;
      inverse_q <= {inverse_q[InverseBits-3:0], digits};
    end

  assign parallel_o = divisor < Bits'(voxel_pkg::VoxelParallel);
  assign inverse_o = parallel_o ? '0 : inverse_q;
endmodule

`default_nettype wire
