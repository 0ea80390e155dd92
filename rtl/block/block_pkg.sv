// Widths, states and fields of the block renderer: the names and values of sc/block/codes.h; and
// the arithmetic of sc/block/numbers.h that several units have.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

package block_pkg;
  /* verilator lint_off UNUSEDPARAM */  // a unit uses some of them

  // Numbers: signed 12.20
  localparam int BlockBits = 32;
  localparam int BlockFraction = 20;
  localparam int BlockRootBits = 23;
  localparam int BlockDistanceBits = 33;
  localparam int BlockFar = 2047;
  localparam int BlockConeSlack = 16384;
  localparam int BlockSmallLength2 = 4096;

  // Spheres
  localparam int BlockEntries = 64;
  localparam int BlockIndexBits = 6;
  localparam int BlockCountBits = 7;
  localparam int BlockFieldBits = 5;

  // Picture, cores and store
  localparam int BlockSide = 16;
  localparam int BlockPlaceBits = 11;
  localparam int BlockCores = 64;
  localparam int BlockStateBits = 4;
  localparam int BlockEventBits = 3;

  /* verilator lint_on UNUSEDPARAM */

  typedef enum logic [3:0] {
    BlockIdle = 4'd0,
    BlockJob = 4'd1,
    BlockCorner = 4'd2,
    BlockCull = 4'd3,
    BlockClear = 4'd4,
    BlockPixel = 4'd5,
    BlockGroup = 4'd6,
    BlockNear = 4'd7,
    BlockDecide = 4'd8,
    BlockShade = 4'd9,
    BlockStore = 4'd10,
    BlockWords = 4'd11,
    BlockShadow = 4'd12,
    BlockShadowGroup = 4'd13,
    BlockShadowNear = 4'd14
  } block_state;

  typedef enum logic [2:0] {
    BlockNoEvent = 3'd0,
    BlockKept0 = 3'd1,
    BlockKept1 = 3'd2,
    BlockKept2 = 3'd3,
    BlockKept3 = 3'd4,
    BlockSmallVector = 3'd5,
    BlockRootOver = 3'd6
  } block_event;

  typedef enum logic [4:0] {
    BlockCentreX = 5'd0,
    BlockCentreY = 5'd1,
    BlockCentreZ = 5'd2,
    BlockRadius = 5'd3,
    BlockRed = 5'd4,
    BlockGreen = 5'd5,
    BlockBlue = 5'd6,
    BlockRv = 5'd7,
    BlockEyeX = 5'd8,
    BlockEyeY = 5'd9,
    BlockEyeZ = 5'd10,
    BlockLightX = 5'd11,
    BlockLightY = 5'd12,
    BlockLightZ = 5'd13,
    BlockScreenWidth = 5'd14,
    BlockScreenHeight = 5'd15,
    BlockRadius2 = 5'd16
  } block_field;

  // --- Arithmetic ------------------------------------------------------------------------------
  typedef logic signed [BlockBits-1:0] number;
  typedef logic signed [BlockFraction+BlockBits-1:0] product;  // what is above a number is dropped
  typedef logic [3*BlockBits-1:0] axes;  // {x, y, z}

  /* verilator lint_off UNUSEDSIGNAL */  // what is below a fraction
  function automatic number fixed_of(input product value);
    fixed_of = value[BlockFraction+:BlockBits];
  endfunction
  /* verilator lint_on UNUSEDSIGNAL */

  function automatic axes sum_of(input axes a, input axes b);
    sum_of = {a[2*BlockBits+:BlockBits] + b[2*BlockBits+:BlockBits],
              a[BlockBits+:BlockBits] + b[BlockBits+:BlockBits],
              a[0+:BlockBits] + b[0+:BlockBits]};
  endfunction

  function automatic axes difference_of(input axes a, input axes b);
    difference_of = {a[2*BlockBits+:BlockBits] - b[2*BlockBits+:BlockBits],
                     a[BlockBits+:BlockBits] - b[BlockBits+:BlockBits],
                     a[0+:BlockBits] - b[0+:BlockBits]};
  endfunction
endpackage

`default_nettype wire
