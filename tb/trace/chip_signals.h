// The signals of the chip on a WiredBench, whatever its units are made of.
//
// A wire and the ports at its ends are one signal with several names: `chip.i2`,
// `chip.u_subdivider.i2_o`. Registers lie beside the ports of their unit, `chip.u_subdivider.i1_q`,
// at the same path in the model and in RTL; what RTL has besides joins them. In lockstep the RTL's
// side is `chip.u_subdivider.rtl`.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tb/bench/wired_bench.h"

namespace racebeam {

/// One signal under one of its names.
struct ChipSignal {
  std::string scope, name;                 ///< "chip.u_subdivider", "i1_q"
  int bits;                                ///< 1..64
  wire_contents wire{};                    ///< of a wire or port
  std::function<std::uint64_t()> inner{};  ///< reads a register, or a signal inside RTL
  bool is_pin = false;                     ///< though `inner` reads it: of a chip in RTL

  std::string path() const { return scope + "." + name; }
  bool is_port() const { return !inner || is_pin; }
  bool is_clock() const { return name == "clk_i" || name == "clk"; }
  /// The same for all names of a wire; nullptr of an inner signal.
  const void* carrier() const {
    return wire.bit ? static_cast<const void*>(wire.bit) : static_cast<const void*>(wire.word);
  }
  /// The raw bits, once the bench has settled.
  std::uint64_t read() const { return inner ? inner() : wire.value(); }
};

/// Where a unit's ports lie: "chip.u_stacks"; of the whole chip "chip".
std::string scope_of_unit(const std::string& unit);

/// All names, unit after unit. They can be read as long as the bench lives.
std::vector<ChipSignal> chip_signals(const WiredBench& bench);

/// The words of a register that holds a state, by value; nullptr: it holds none, or, in somebody's
/// own RTL, others.
const std::vector<std::string>* state_words(const ChipSignal& signal);

/// One of them that shows what names look like: a state, if the chip has one.
const ChipSignal& example_of(const std::vector<ChipSignal>& signals);

}  // namespace racebeam
