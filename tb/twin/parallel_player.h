// Recorded traffic of up to 64 parts goes into as many instances of a netlist at once.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tb/twin/packed_row.h"
#include "tb/twin/parallel_gates.h"

namespace racebeam {

class ParallelPlayer {
 public:
  static constexpr std::size_t Instances = ParallelGates::Instances;
  using Word = ParallelGates::Word;
  /// By instance, as PackedRow has it.
  using Rows = std::array<const char*, Instances>;

  /// Instances from power-up on. Throws RtlError: what ParallelGates does, and ports of the traffic
  /// that are missing or wrongly sized; the netlist may do without an optional one.
  ParallelPlayer(const std::string& netlist, const std::vector<PortTraffic::Port>& ports);

  const PackedRow& row() const { return row_; }
  /// A clock with the inputs of the rows: the instances of `compared` whose outputs are others.
  Word clock(const Rows& rows, Word compared);

 private:
  struct Bits {
    std::size_t offset, bytes;
    std::vector<std::size_t> nets;
    std::array<std::uint64_t, Instances> last;  // as the rows have it
    std::vector<Word> words;                    // the same by bit
  };
  bool take(Bits& port, const Rows& rows);

  const PackedRow row_;
  ParallelGates gates_;
  std::vector<Bits> inputs_, outputs_;
};

}  // namespace racebeam
