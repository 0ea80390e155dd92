// What the tlm level's transactions are, from the cores run clock by clock: nothing of tb/trace/
// and no observer is used. Pixels take whole clocks here: no speed pins.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sc/beam/chip_core.h"

namespace racebeam {

class TransactionAccount {
 public:
  /// Runs the demo from the start of `frame` to clock `end`, and keeps the texts of the clocks from
  /// `begin` on; both are counted from the start of the frame.
  TransactionAccount(const knobs& k, int frame, std::int64_t begin, std::int64_t end);

  /// The changes that a waveform of the window has, by time in ps; the first frame begins at
  /// `origin`.
  std::map<std::uint64_t, std::string> changes(const std::string& path, std::uint64_t origin) const;
  /// Transactions that were longer than nothing, whether in the window or not.
  int count(const std::string& path) const;

  static std::string rgb(int colour);

 private:
  void run_line(int frame, int line);
  // A pixel's colour is that of its last clock.
  void show(int y, std::int64_t n, int clock, int uo);
  void put(const std::string& path, std::int64_t n, const std::string& text);
  // One transaction; the one before it must look different.
  void fill(const std::string& path, std::int64_t from, std::int64_t to, const std::string& text);

  const knobs knobs_;
  const int line_clocks_;
  const std::int64_t begin_, end_;
  chip_core chip_;
  std::vector<std::string> texts_{"-"};
  std::map<std::string, int> ids_, counts_;
  std::map<std::string, std::vector<int>> streams_;  // by path: the text of each clock
};

}  // namespace racebeam
