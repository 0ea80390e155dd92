// voxel_address: where a voxel's occupancy bit is in the memory.
// Contract: sc/voxel/voxel_address.h
//
// Morton order is wires. With sides that are powers of two the number of a tile is too, and the
// level's offset the only adder.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module voxel_address #(
    parameter int SizeX = 64,
    parameter int SizeY = 64,
    parameter int SizeZ = 32,
    parameter int VoxelX = 1,
    parameter int VoxelY = 4,
    parameter int VoxelZ = 1,
    parameter int Levels = 5
) (
    // voxel_walker
    input  wire logic [voxel_pkg::VoxelCoordinateBits-1:0] x_i,  // signed
    input  wire logic [voxel_pkg::VoxelCoordinateBits-1:0] y_i,
    input  wire logic [voxel_pkg::VoxelCoordinateBits-1:0] z_i,
    input  wire logic [voxel_pkg::VoxelLevelBits-1:0] level_i,
    // occupancy_memory
    output logic [voxel_pkg::VoxelWordBits-1:0] word_o,
    output logic [voxel_pkg::VoxelBitBits-1:0] bit_o,
    output logic inside_o
);
  localparam int Bits = voxel_pkg::VoxelCoordinateBits;
  localparam int WordBits = voxel_pkg::VoxelWordBits;
  localparam int CellBits = $clog2(voxel_pkg::VoxelTileWords * voxel_pkg::VoxelMemoryBits);
  localparam int TileBits = WordBits + voxel_pkg::VoxelBitBits - CellBits;
  localparam int PlaceBits = $clog2(voxel_pkg::VoxelTile);

  typedef logic [TileBits-1:0] tile_number;

  function automatic int tiles_of(input int side, input int level);
    tiles_of = ((side >> level) + voxel_pkg::VoxelTile - 1) / voxel_pkg::VoxelTile;
  endfunction

  // Tiles of the levels below one.
  function automatic int tiles_below(input int level);
    tiles_below = 0;
    for (int k = 0; k < level; k++)
      tiles_below = tiles_below + tiles_of(SizeX / VoxelX, k) * tiles_of(SizeY / VoxelY, k)
          * tiles_of(SizeZ / VoxelZ, k);
  endfunction

  // A product with a constant: adders of what its ones shift.
  function automatic tile_number times(input tile_number value, input int factor);
    times = '0;
    for (int n = 0; n < TileBits; n++) if (factor[n]) times = times + (value << n);
  endfunction

  wire logic [Bits-1:0] x, y, z;
  voxel_wrap #(
      .Side(SizeX / VoxelX),
      .Levels(Levels)
  ) u_voxel_wrap_x (
      .value_i(x_i),
      .level_i(level_i),
      .place_o(x)
  );
  voxel_wrap #(
      .Side(SizeY / VoxelY),
      .Levels(Levels)
  ) u_voxel_wrap_y (
      .value_i(y_i),
      .level_i(level_i),
      .place_o(y)
  );
  voxel_wrap #(
      .Side(SizeZ / VoxelZ),
      .Levels(Levels)
  ) u_voxel_wrap_z (
      .value_i(z_i),
      .level_i(level_i),
      .place_o(z)
  );

  // --- Tiles along x, then y, then z ------------------------------------------------------------
  tile_number tile, first;
  logic [Bits-1:0] side_z;
  wire tile_number tile_x = TileBits'(x[Bits-1:PlaceBits]);
  wire tile_number tile_y = TileBits'(y[Bits-1:PlaceBits]);
  wire tile_number tile_z = TileBits'(z[Bits-1:PlaceBits]);
  always_comb begin
    {tile, first, side_z} = '0;
    for (int k = 0; k < Levels; k++)
      if (k == 0 || level_i == voxel_pkg::VoxelLevelBits'(k)) begin
        tile = times(times(tile_z, tiles_of(SizeY / VoxelY, k)) + tile_y,
                     tiles_of(SizeX / VoxelX, k)) + tile_x;
        first = TileBits'(tiles_below(k));
        side_z = Bits'(SizeZ / VoxelZ >> k);
      end
  end
  wire tile_number number = first + tile;

  // --- Morton order, x lowest -------------------------------------------------------------------
  assign {word_o, bit_o} = {number, z[2], y[2], x[2], z[1], y[1], x[1], z[0], y[0], x[0]};

  assign inside_o = z_i < side_z;  // a negative one is more than any side
endmodule

`default_nettype wire
