// tlm_map: the addresses of tlm_chip's two sockets.
//
// display_socket writes, little endian, no byte enables:
//   640 * row           640 bytes  a visible line, row 0..479: r * 16 + g * 4 + b of each column
//   DisplayFrame        4 bytes    the number of a frame, after its last line
//   DisplayPins + ...   a byte per clock, if the pins are wanted: uo in the clocks of a line, at
//                       DisplayLinePitch * (y + 273)
//   DisplaySound + ...  words, if the sound is wanted: the changes of the PWM pin in a line, each
//                       clock * 2 + level, at DisplayLinePitch * (y + 273); none: no transaction
// So a memory of 307,204 bytes is a display.
//
// register_socket reads words of 32 bits, little endian; aligned, any number in a row.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/base/constants.h"
#include "sc/beam/counters.h"

namespace racebeam {

constexpr std::uint64_t DisplayFrame = std::uint64_t{VisibleColumns} * VisibleRows;
constexpr std::uint64_t DisplayPins = 0x0100'0000;
constexpr std::uint64_t DisplaySound = 0x0200'0000;
constexpr std::uint64_t DisplayLinePitch = 0x4000;

enum register_address : std::uint64_t {
  RegisterId = 0x000,          ///< RegisterIdValue
  RegisterFrame = 0x004,       ///< frame counter
  RegisterLine = 0x008,        ///< y of the next line, -273..251
  RegisterFrames = 0x00c,      ///< whole frames since the start, modulo 2^32
  RegisterClocks = 0x010,      ///< clocks since the start, 64 bits
  RegisterLineClocks = 0x018,  ///< clocks of a line
  RegisterPeriod = 0x01c,      ///< of the clock, in ps
  RegisterReset = 0x020,       ///< write only: bit 0 resets the chip before its next line
  RegisterKnobs = 0x100,       ///< a word each, signed, in the order of knob_table()
  // Of the last whole frame; 0 before. 64 bits each, or words per visible line.
  RegisterCounters = 0x200,    ///< in the order of counter_registers()
  RegisterHistograms = 0x400,  ///< in the order of histogram_table(), at HistogramPitch
  RegisterFifoFill = 0x400,
  RegisterStackDepth = 0x800,
  RegisterWalkSteps = 0xc00,
  RegisterSlack = 0x1000,
  RegisterLines = 0x4000,  ///< in the order of line_table(), at LinesPitch
  RegisterCameraClocks = 0x4000,
  RegisterFirstEmit = 0x4800,
  RegisterDoneClock = 0x5000,
  RegisterBusyClocks = 0x5800,
  RegisterStackNeeded = 0x6000,
  RegisterLineParts = 0x6800,  ///< in the order of line_part
};
constexpr std::uint64_t HistogramPitch = 0x400, LinesPitch = 0x800;
constexpr std::uint32_t RegisterIdValue = 0x6d616562;  // "beam"

}  // namespace racebeam
