// TtChip: any chip behind the pins of a Tiny Tapeout tile, verilated.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sc/swap/rtl_library.h"
#include "tb/monitor/pin_change.h"
#include "tb/tt/tt_inputs.h"

namespace racebeam {

class TtChip {
 public:
  /// A plug-in of registered inputs, with its input pins; ena is 1. Files that the RTL reads are
  /// looked for in `folder`. Throws RtlError if the ports are not those of a tile. From then on all
  /// that simulates throws RtlFault.
  TtChip(const std::string& plugin, const std::string& folder, TilePins inputs);

  /// Its input pins from this clock on; the logic sees them a clock later.
  void set_inputs(TilePins inputs);

  /// Holds rst_n at 0 for some clocks. The next clock is clock 0.
  void reset(int clocks);

  /// Simulates clocks and adds what changes; the first clock after reset is always added. Throws
  /// Interrupted, but only in the middle of many clocks.
  void run(std::uint64_t clocks, std::vector<PinChange>& changes);

  /// Clocks simulated since reset.
  std::uint64_t clock() const { return clock_; }
  /// Its ports, and the signals inside if the plug-in has them, as they are in that clock.
  const rtl_model& model() const { return library_.model(); }

 private:
  std::uint8_t& pin(const char* name) const;
  void first_evaluation(const std::string& folder);

  rtl_library library_;
  std::uint8_t *rst_n_, *ui_in_, *uio_in_;
  const std::uint8_t *uo_, *uio_, *oe_;
  std::uint64_t clock_ = 0;
  PinChange last_{};
};

}  // namespace racebeam
