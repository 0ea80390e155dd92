// voxel_wrap: one axis of voxel_address: the place in the world of a coordinate in the world that
// repeats, in the voxels of a level.
//
// A side is an odd number times a power of two, and that power is never less than the level's. Of
// the power the low bits are cut, which is wires; of an odd number above 1 its multiples are taken
// off.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_wrap #(
    parameter int Side = 64,  // of the finest level
    parameter int Levels = 5
) (
    input  wire logic [voxel_pkg::VoxelCoordinateBits-1:0] value_i,  // signed
    input  wire logic [voxel_pkg::VoxelLevelBits-1:0] level_i,
    output logic [voxel_pkg::VoxelCoordinateBits-1:0] place_o
);
  localparam int Bits = voxel_pkg::VoxelCoordinateBits;

  function automatic int twos_of(input int side);
    twos_of = 0;
    for (int n = 1; n < Bits; n++) if (side % (1 << n) == 0) twos_of = n;
  endfunction
  localparam int Twos = twos_of(Side);
  localparam int Odd = Side >> Twos;

  logic [Bits-1:0] rest;  // of the value's part above the power of two

  if (Odd == 1) begin : g_wires
    assign rest = '0;
  end else begin : g_odd
    localparam int Most = 1 << (Bits - 1);
    localparam int Multiple = (Most + Odd - 1) / Odd * Odd;  // makes all values positive
    localparam int RestBits = Bits + 2;
    wire logic signed [Bits-1:0] value = value_i;
    logic [RestBits-1:0] taken;
    always_comb begin
      taken = RestBits'(value >>> Twos);
      for (int k = 1; k < Levels; k++)
        if (level_i == voxel_pkg::VoxelLevelBits'(k)) taken = RestBits'(value >>> (Twos - k));
      taken = taken + RestBits'(Multiple);
      for (int n = Bits; n >= 0; n--)
        if (Odd >> (RestBits - n) == 0 && taken >= RestBits'(Odd << n))
          taken = taken - RestBits'(Odd << n);
    end
    assign rest = taken[Bits-1:0];
  end

  always_comb begin
    place_o = rest << Twos | (value_i & Bits'((1 << Twos) - 1));
    for (int k = 1; k < Levels; k++)
      if (level_i == voxel_pkg::VoxelLevelBits'(k))
        place_o = rest << (Twos - k) | (value_i & Bits'((1 << (Twos - k)) - 1));
  end
endmodule

`default_nettype wire
