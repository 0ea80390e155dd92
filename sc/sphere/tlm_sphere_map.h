// tlm_sphere_map: the addresses of tlm_sphere's sockets. Words of 32 bits, little endian.
//
// display_socket: as tlm_picture_chip has it, of 640 x 480 at most; a memory of 921,612 bytes is a
// display.
//
// host_socket is what the CPU's wires are to sphere_host_link: a sphere is 11 words.
// register_socket: aligned, any number of words in a row.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace racebeam {

enum sphere_host_address : std::uint64_t {
  // Write only; the low bits are taken.
  SphereHostSphere = 0x00,  ///< {number of spheres, index of this one}, 4 bits each
  SphereHostColor = 0x04,   ///< {light, red, green, blue}
  SphereHostX1 = 0x08,      ///< signed, 12.12
  SphereHostY1 = 0x0c,
  SphereHostZ1 = 0x10,
  SphereHostReflect = 0x14,
  SphereHostRadius = 0x18,
  SphereHostR2 = 0x1c,
  SphereHostRInv = 0x20,
  SphereHostValid = 0x24,  ///< bit 0
  // Read only
  SphereHostRotz = 0x28,  ///< turns that are asked for, a bit each
  SphereHostDone = 0x2c,  ///< 1: the tracer waits for spheres
  SphereHostEnd = 0x30
};

enum sphere_register_address : std::uint64_t {
  SphereRegisterId = 0x000,        ///< SphereRegisterIdValue
  SphereRegisterPictures = 0x004,  ///< drawn since the start, modulo 2^32
  SphereRegisterClocks = 0x010,    ///< since the last reset, 64 bits
  SphereRegisterPeriod = 0x01c,    ///< of the clock, in ps
  SphereRegisterReset = 0x020,     ///< write only: bit 0 resets it at the end of the picture
  SphereRegisterSwitches = 0x024,  ///< read and write: SW17..SW0
  SphereRegisterKeys = 0x028,      ///< read and write: KEY3..KEY0, 0 while pressed
  SphereRegisterKnobs = 0x100,     ///< a word each, signed, in the order of sphere_knob_table()
  // Of the last picture that is drawn; 0 before. 64 bits each.
  SphereRegisterCounters = 0x200,  ///< in the order of sphere_counter_infos()
  SphereRegisterFill = 0x400       ///< the histogram of the write buffer's fill
};
constexpr std::uint32_t SphereRegisterIdValue = 0x72687073;  // "sphr"

}  // namespace racebeam
