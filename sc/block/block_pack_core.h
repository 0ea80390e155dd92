// Behaviour of block_pack (block_pack.h).
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace racebeam {

struct block_pack_core {
  std::uint64_t red_q = 0, green_q = 0, blue_q = 0;
  int count_q = 0;

  struct inputs {
    bool rst_n, valid;
    int red, green, blue;
  };

  bool full(bool valid) const { return valid && count_q == 7; }
  void clock(const inputs& in) {
    if (!in.rst_n) {
      *this = {};
    } else if (in.valid) {
      red_q = pushed(red_q, in.red);
      green_q = pushed(green_q, in.green);
      blue_q = pushed(blue_q, in.blue);
      count_q = (count_q + 1) & 7;
    }
  }

  /// Calls visit(name, bits, read) for each register.
  template <class Visit>
  void each_register(Visit&& visit) const {
    visit("red_q", 64, [this] { return red_q; });
    visit("green_q", 64, [this] { return green_q; });
    visit("blue_q", 64, [this] { return blue_q; });
    visit("count_q", 3, [this] { return count_q; });
  }

 private:
  static std::uint64_t pushed(std::uint64_t word, int byte) {
    return word >> 8 | static_cast<std::uint64_t>(byte) << 56;
  }
};

}  // namespace racebeam
