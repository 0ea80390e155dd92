// tlm_block_map: the addresses of tlm_block's sockets. Words of 32 bits, little endian.
//
// display_socket: as tlm_picture_chip has it, of 1920 x 1080 at most; a memory of 6,220,812 bytes
// is a display.
//
// host_socket: what the host says of the scene; numbers are floats. All of it can be read.
// register_socket: aligned, any number of words in a row.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace racebeam {

constexpr int BlockDisplayColumns = 1920, BlockDisplayRows = 1080;

enum block_host_address : std::uint64_t {
  BlockHostControl = 0x000,  ///< bit 0: start, if written; 1: a picture is drawn, if read
  BlockHostSpheres = 0x004,  ///< their number, 0..64
  BlockHostEye = 0x010,      ///< 3 floats
  BlockHostLight = 0x020,    ///< 3 floats
  BlockHostScreen = 0x030,   ///< 2 floats: width, height
  BlockHostSize = 0x038,     ///< read only: {rows, columns} of the picture, 16 bits each
  /// 32 bytes a sphere: 7 floats: centre, radius, red, green, blue
  BlockHostTable = 0x100,
  BlockHostEnd = 0x900
};
constexpr std::uint64_t BlockHostRow = 32;
constexpr int BlockHostNumbers = 7;  // of a sphere

enum block_register_address : std::uint64_t {
  BlockRegisterId = 0x000,        ///< BlockRegisterIdValue
  BlockRegisterPictures = 0x004,  ///< drawn since the start, modulo 2^32
  BlockRegisterClocks = 0x010,    ///< since the reset, 64 bits
  BlockRegisterPeriod = 0x01c,    ///< of the clock, in ps
  BlockRegisterKnobs = 0x100,     ///< a word each, signed, in the order of block_knob_table()
  // Of the last picture that is drawn; 0 before. 64 bits each.
  BlockRegisterCounters = 0x200,  ///< in the order of block_counter_infos()
  BlockRegisterBusy = 0x400       ///< busy clocks of each core
};
constexpr std::uint32_t BlockRegisterIdValue = 0x6b636c62;  // "blck"

}  // namespace racebeam
