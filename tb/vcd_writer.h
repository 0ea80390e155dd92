// VcdWriter: a value change dump (IEEE 1364-2005, 18.2), collected in memory.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace racebeam {

/// Times in picoseconds. Signals are added before the first change.
class VcdWriter {
 public:
  /// A signal of 1..64 bits in a scope such as "chip.u_stacks"; returns its number.
  int add(const std::string& scope, const std::string& name, int bits);

  /// The signal has this value from `time` on; nothing is written if it had it already. Times
  /// never fall.
  void change(std::uint64_t time, int signal, std::uint64_t value);

  /// The file, up to `end`. `comment` says where it comes from.
  std::string text(const std::string& comment, std::uint64_t end) const;

 private:
  struct Signal {
    std::string scope, name;
    int bits;
    bool known = false;
    std::uint64_t value = 0;
  };

  std::vector<Signal> signals_;
  std::string changes_;
  std::uint64_t time_ = 0;
  bool started_ = false;
};

}  // namespace racebeam
