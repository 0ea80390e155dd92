// Widths, states and fields of the block renderer, the same in rtl/block/block_pkg.sv.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace racebeam {

// Numbers: signed 12.20.
constexpr int BlockBits = 32;
constexpr int BlockFraction = 20;
constexpr int BlockRootBits = 23;        // what block_root takes the root of, and the root
constexpr int BlockDistanceBits = 33;    // the discriminant
constexpr int BlockFar = 2047;           // whole units: nothing is hit there or beyond
constexpr int BlockConeSlack = 16384;    // 12.20: 1/64, of a sphere in its cone test
constexpr int BlockSmallLength2 = 4096;  // 12.20; squares of lengths below are small vectors'

// Spheres.
constexpr int BlockEntries = 64;
constexpr int BlockIndexBits = 6;
constexpr int BlockCountBits = 7;
constexpr int BlockFieldBits = 5;

// Picture, cores and store.
constexpr int BlockSide = 16;  // pixels of a block
constexpr int BlockPlaceBits = 11;
constexpr int BlockCores = 64;
constexpr int BlockStateBits = 4;
constexpr int BlockEventBits = 3;
constexpr int BlockAddressBits = 20;

/// Where block_core is.
enum block_state {
  BlockIdle = 0,
  BlockJob = 1,
  BlockCorner = 2,
  BlockCull = 3,
  BlockClear = 4,
  BlockPixel = 5,
  BlockGroup = 6,
  BlockNear = 7,
  BlockDecide = 8,
  BlockShade = 9,
  BlockStore = 10,
  BlockWords = 11,
  BlockShadow = 12,
  BlockShadowGroup = 13,
  BlockShadowNear = 14
};

/// What counters are told of block_core besides its state.
enum block_event {
  BlockNoEvent = 0,
  BlockKept0 = 1,  // a block, by corner ul, bl, br, ur: the first that does
  BlockKept1 = 2,
  BlockKept2 = 3,
  BlockKept3 = 4,
  BlockSmallVector = 5,  // becomes a unit vector
  BlockRootOver = 6      // a root of 8.0 and above
};

/// What a number of the world is; block_convert makes BlockRv and BlockRadius2, the square of
/// BlockRadius.
enum block_field {
  BlockCentreX = 0,
  BlockCentreY = 1,
  BlockCentreZ = 2,
  BlockRadius = 3,
  BlockRed = 4,
  BlockGreen = 5,
  BlockBlue = 6,
  BlockRv = 7,
  BlockEyeX = 8,
  BlockEyeY = 9,
  BlockEyeZ = 10,
  BlockLightX = 11,
  BlockLightY = 12,
  BlockLightZ = 13,
  BlockScreenWidth = 14,
  BlockScreenHeight = 15,
  BlockRadius2 = 16
};

}  // namespace racebeam
