// PinChange: what the output pins of a Tiny Tapeout tile are from some clock on.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace racebeam {

struct PinChange {
  std::uint64_t clock;  ///< since reset
  std::uint8_t uo;      ///< uo_out: TinyVGA
  std::uint8_t uio;     ///< uio_out
  std::uint8_t oe;      ///< uio_oe: 1 where the chip drives uio
};

}  // namespace racebeam
