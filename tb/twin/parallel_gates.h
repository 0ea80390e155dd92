// 64 instances of a netlist of gates at once: each net is a word, each instance a bit of it.
//
// A gate takes about a nanosecond for all of them, and none of it is compiled: recorded traffic of
// 64 parts of a show goes through a netlist in the time of one. Two states, registers begin with 0.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace racebeam {

class ParallelGates {
 public:
  static constexpr std::size_t Instances = 64;
  using Word = std::uint64_t;  ///< bit N is that of instance N

  /// `netlist`: text of what `scripts/netlist --bits` writes. Throws RtlError: it is something
  /// else, has a loop of gates, or more than one clock.
  explicit ParallelGates(const std::string& netlist);

  struct Port {
    bool input;
    std::vector<std::size_t> nets;  ///< of its bits, the lowest first
  };
  /// By name, but for the clock.
  const std::map<std::string, Port>& ports() const { return ports_; }
  std::size_t gates() const { return gates_; }

  Word& net(std::size_t number) { return values_[number]; }
  /// What follows from the inputs and registers.
  void settle();
  /// A rising edge after settle(), of which nothing follows yet.
  void edge();

 private:
  class Reader;
  enum class Kind : std::uint8_t { Buffer, Not, And, Or, Xor, Mux };
  struct Gate {
    std::uint32_t a, b, select;  // nets
  };
  /// Gates of one kind that do not depend on each other, with the nets from `out` on.
  struct Run {
    Kind kind;
    std::size_t begin, end, out;
  };

  std::map<std::string, Port> ports_;
  std::vector<Word> values_;  // of nets: constants, inputs, registers, gates
  std::vector<Gate> inputs_of_;
  std::vector<Run> runs_;
  std::size_t gates_ = 0, first_register_ = 0;
  std::vector<std::uint32_t> next_;  // the nets that registers take
  std::vector<Word> taken_;
};

}  // namespace racebeam
