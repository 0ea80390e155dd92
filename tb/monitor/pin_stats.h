// What the output pins of a tile did: how often they changed, how long they were 1.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bitset>
#include <cstdint>

#include "tb/monitor/pin_change.h"

namespace racebeam {

struct PinStats {
  static constexpr int Pins = 16;  ///< uo_out[0..7], uio_out[0..7]

  std::uint64_t clocks = 0;
  std::array<std::uint64_t, Pins> toggles{};  ///< changes
  std::array<std::uint64_t, Pins> high{};     ///< clocks at 1
  std::array<std::uint64_t, Pins> enabled{};  ///< clocks in which the chip drives the pin
  std::bitset<64> colours{};                  ///< those of the picture

  PinStats& operator+=(const PinStats& more);
};

/// Counts from one take() to the next.
class PinCounter {
 public:
  /// Clocks do not run backwards; the first call counts for what was before, too.
  void change(const PinChange& now);
  /// What was counted before `clock`; counting goes on there. The colours are the caller's.
  PinStats take(std::uint64_t clock);

 private:
  void count_until(std::uint64_t clock);

  PinStats stats_;
  PinChange last_{};
  bool started_ = false;
};

}  // namespace racebeam
