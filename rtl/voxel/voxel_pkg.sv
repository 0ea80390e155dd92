// Widths, states and kinds of the voxel tracer: the names and values of sc/voxel/codes.h.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

package voxel_pkg;
  /* verilator lint_off UNUSEDPARAM */  // a unit uses some of them

  // Numbers
  localparam int VoxelPositionBits = 24;
  localparam int VoxelPositionFraction = 8;
  localparam int VoxelCameraBits = 32;
  localparam int VoxelDirectionBits = 18;
  localparam int VoxelDirectionFraction = 16;
  localparam int VoxelInverseBits = 32;
  localparam int VoxelInverseFraction = 20;
  localparam int VoxelTBits = 32;
  localparam int VoxelParallel = 16;

  // The world
  localparam int VoxelCoordinateBits = 16;
  localparam int VoxelLevelBits = 4;
  localparam int VoxelMaxLevels = 9;
  localparam int VoxelTile = 8;
  localparam int VoxelTileWords = 16;
  localparam int VoxelWordBits = 27;
  localparam int VoxelBitBits = 5;
  localparam int VoxelMemoryBits = 32;
  localparam int VoxelColumnBits = 25;
  localparam int VoxelHeightBits = 8;
  localparam int VoxelMaxSide = 16384;
  localparam int VoxelMaxHeight = 256;
  localparam int VoxelMaxVoxel = 16;

  // Ports
  localparam int VoxelLimitBits = 10;
  localparam int VoxelKindBits = 2;
  localparam int VoxelStateBits = 4;
  localparam int VoxelBuilderStateBits = 3;
  localparam int VoxelSampleBits = 8;
  localparam int VoxelRectangleBits = 15;
  localparam int VoxelScanStateBits = 2;
  localparam int VoxelRowBits = 9;
  localparam int VoxelPlaceBits = 10;
  localparam int VoxelColourBits = 24;
  localparam int VoxelPaletteBits = 7;
  localparam int VoxelPaletteEntries = 128;
  localparam int VoxelPaletteHeights = 16;

  // The sky
  localparam int VoxelSkyRed = 72;
  localparam int VoxelSkyGreen = 136;
  localparam int VoxelSkyBlue = 224;
  localparam int VoxelSkyRedStep = 8;
  localparam int VoxelSkyGreenStep = 6;
  localparam int VoxelSkyBlueStep = 2;
  localparam int VoxelSkyMiddle = 7;

  /* verilator lint_on UNUSEDPARAM */

  typedef enum logic [3:0] {
    VoxelIdle = 4'd0,
    VoxelSetup = 4'd1,
    VoxelFetch = 4'd2,
    VoxelDown = 4'd3,
    VoxelExit = 4'd4,
    VoxelLeaf = 4'd5,
    VoxelMove = 4'd6,
    VoxelLimit = 4'd7
  } voxel_state;

  typedef enum logic [1:0] {
    VoxelSky = 2'd0,
    VoxelHit = 2'd1,
    VoxelOuterLimit = 2'd2,
    VoxelInnerLimit = 2'd3
  } voxel_kind;

  typedef enum logic [2:0] {
    VoxelBuilderIdle = 3'd0,
    VoxelBuilderClear = 3'd1,
    VoxelBuilderFill = 3'd2,
    VoxelBuilderUp = 3'd3
  } voxel_builder_state;

  typedef enum logic [1:0] {
    VoxelScanIdle = 2'd0,
    VoxelScanRay = 2'd1,
    VoxelScanShadow = 2'd2,
    VoxelScanShade = 2'd3
  } voxel_scan_state;
endpackage

`default_nettype wire
