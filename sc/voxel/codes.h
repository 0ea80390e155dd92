// Widths, states and kinds of the voxel tracer, the same in rtl/voxel/voxel_pkg.sv.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

// Numbers
constexpr int VoxelPositionBits = 24;       // signed 16.8
constexpr int VoxelPositionFraction = 8;    // of positions and of t
constexpr int VoxelCameraBits = 32;         // signed 2.24, with room for sums
constexpr int VoxelDirectionBits = 18;      // signed 2.16
constexpr int VoxelDirectionFraction = 16;  //
constexpr int VoxelInverseBits = 32;        // unsigned 12.20
constexpr int VoxelInverseFraction = 20;    //
constexpr int VoxelTBits = 32;              // unsigned 24.8, at most 2^31: never
constexpr int VoxelParallel = 16;           // a direction below it, in 2^-16, has no inverse

// The world
constexpr int VoxelCoordinateBits = 16;  // signed: a voxel's place in its level
constexpr int VoxelLevelBits = 4;
constexpr int VoxelMaxLevels = 9;
constexpr int VoxelTile = 8;        // voxels along a side of a tile
constexpr int VoxelTileWords = 16;  // of 32 bits
constexpr int VoxelWordBits = 27;   // address of a word of occupancy
constexpr int VoxelBitBits = 5;     // of a bit in it
constexpr int VoxelMemoryBits = 32;
constexpr int VoxelColumnBits = 25;  // address of a column
constexpr int VoxelHeightBits = 8;
constexpr int VoxelMaxSide = 16384;
constexpr int VoxelMaxHeight = 256;
constexpr int VoxelMaxVoxel = 16;

// Ports
constexpr int VoxelLimitBits = 10;
constexpr int VoxelKindBits = 2;
constexpr int VoxelStateBits = 4;
constexpr int VoxelBuilderStateBits = 3;
constexpr int VoxelSampleBits = 8;
constexpr int VoxelRectangleBits = 15;
constexpr int VoxelScanStateBits = 2;
constexpr int VoxelRowBits = 9;      // of a picture
constexpr int VoxelPlaceBits = 10;   // of a picture's column
constexpr int VoxelColourBits = 24;  // red, green, blue of 8, blue lowest
constexpr int VoxelPaletteBits = 7;  // material, height
constexpr int VoxelPaletteEntries = 128;
constexpr int VoxelPaletteHeights = 16;  // of a material

// The sky: of a ray straight up, and how much more a sixteenth of its slope below that
constexpr int VoxelSkyRed = 72;
constexpr int VoxelSkyGreen = 136;
constexpr int VoxelSkyBlue = 224;
constexpr int VoxelSkyRedStep = 8;
constexpr int VoxelSkyGreenStep = 6;
constexpr int VoxelSkyBlueStep = 2;
constexpr int VoxelSkyMiddle = 7;  // the slope of which the plain one has its colour

/// Where voxel_walker is.
enum voxel_state {
  VoxelIdle = 0,
  VoxelSetup = 1,
  VoxelFetch = 2,
  VoxelDown = 3,
  VoxelExit = 4,
  VoxelLeaf = 5,
  VoxelMove = 6,
  VoxelLimit = 7
};

/// How a ray ends.
enum voxel_kind {
  VoxelSky = 0,
  VoxelHit = 1,
  VoxelOuterLimit = 2,  // stopped: what it shows is the column beneath it
  VoxelInnerLimit = 3
};

/// Where voxel_builder is.
enum voxel_builder_state {
  VoxelBuilderIdle = 0,
  VoxelBuilderClear = 1,
  VoxelBuilderFill = 2,
  VoxelBuilderUp = 3
};

/// Where voxel_scan is.
enum voxel_scan_state {
  VoxelScanIdle = 0,
  VoxelScanRay = 1,
  VoxelScanShadow = 2,
  VoxelScanShade = 3
};

}  // namespace racebeam
