// Wires of the chip behind the ports of a unit, for who reads and drives them without asking the
// ports.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sc/base/unit.h"

namespace racebeam {

/// Bits of a word that are known to fit.
struct word_bits : sc_dt::sc_uint_base {
  static constexpr auto of = &word_bits::m_val;
};

/// A bool if the wire has one bit, otherwise a std::uint64_t.
inline const void* place_of(const wire_contents& wire) {
  return wire.bit ? static_cast<const void*>(wire.bit) : &(wire.word->*word_bits::of);
}

/// Writes a wire that no process waits for: the kernel need not know.
inline void put(const wire_contents& wire, std::uint64_t value) {
  if (wire.bit) *const_cast<bool*>(wire.bit) = value != 0;
  else const_cast<sc_dt::sc_uint_base*>(wire.word)->*word_bits::of = value;
}

/// The wire of a bound port. Throws RtlError: it is another channel.
any_wire& wire_of(any_port& pin);

}  // namespace racebeam
