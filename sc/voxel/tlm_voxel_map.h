// tlm_voxel_map: the addresses of tlm_voxel's sockets. Words of 32 bits, little endian.
//
// display_socket: as tlm_picture_chip has it, of 640 x 480 at most; a memory of 921,612 bytes is a
// display.
//
// host_socket: what the host says of the world and of a picture's rays; signed numbers in two's
// complement. register_socket: aligned, any number of words in a row.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace racebeam {

constexpr int VoxelDisplayColumns = 640, VoxelDisplayRows = 480;

enum voxel_host_address : std::uint64_t {
  // Read only
  VoxelHostSize = 0x00,    ///< of the world: {y, x}, 16 bits each; its height is a knob
  VoxelHostVoxel = 0x04,   ///< the smallest: {z, y, x}, 8 bits each
  VoxelHostLevels = 0x08,  ///< of the octree
  // Columns to be built, low limits included, high ones not
  VoxelHostLow = 0x0c,           ///< {y, x}, 16 bits each
  VoxelHostHigh = 0x10,          ///< the same; writing it starts the builder
  VoxelHostStatus = 0x14,        ///< read only: bit 0: it builds; bit 1: a picture is drawn
  VoxelHostOrigin = 0x20,        ///< 3 words, 16.8
  VoxelHostD00 = 0x2c,           ///< 3 words, 2.24
  VoxelHostDx = 0x38,            ///< 3 words, 2.24
  VoxelHostDy = 0x44,            ///< 3 words, 2.24
  VoxelHostStart = 0x50,         ///< bit 0: start of a picture; reads 0
  VoxelHostLight = 0x54,         ///< 3 words, 2.16
  VoxelHostPalette = 0x200,      ///< 128 words: RGB888 of material * 16 + height
  VoxelHostColumns = 0x01000000  ///< a word each, y * size x + x
};

enum voxel_register_address : std::uint64_t {
  VoxelRegisterId = 0x000,        ///< VoxelRegisterIdValue
  VoxelRegisterPictures = 0x004,  ///< drawn since the start, modulo 2^32
  VoxelRegisterClocks = 0x010,    ///< since the reset, 64 bits
  VoxelRegisterPeriod = 0x01c,    ///< of the clock, in ps
  VoxelRegisterKnobs = 0x100,     ///< a word each, signed, in the order of voxel_knob_table()
  // Of the last picture that is drawn; 0 before. 64 bits each.
  VoxelRegisterCounters = 0x200  ///< in the order of voxel_counter_infos()
};
constexpr std::uint32_t VoxelRegisterIdValue = 0x6c786f76;  // "voxl"

}  // namespace racebeam
