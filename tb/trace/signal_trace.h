// SignalTrace: signals of the chip on a WiredBench as those of a VCD, clock by clock.
//
// Where the beam is stands in `beam`. A state register is a word too:
// `chip.u_subdivider.state_q_name`.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "tb/trace/chip_signals.h"
#include "tb/trace/trace_window.h"
#include "tb/wave/selection.h"
#include "tb/wave/vcd_writer.h"

namespace racebeam {

class SignalTrace {
 public:
  /// Adds `signals` to `vcd`, which outlives the trace. Registers are to be watched. `part`: what a
  /// frame of our chip shows; empty: it is another chip. `overview`: of a window so long that all
  /// would be too much; ports and wires only, and not those that change in nearly every clock.
  /// Throws UsageError if nothing is selected.
  SignalTrace(const std::vector<ChipSignal>& signals, const TraceAxis& raster, int period_ps,
              const TraceSelection& selection, bool overview, std::function<std::string(int)> part,
              VcdWriter& vcd);

  /// The values of this clock, which the bench stands in, settled.
  void sample(const TracePoint& at);

 private:
  static constexpr int None = -1;
  struct Bit {
    const bool* at;
    int signal;
  };
  struct Word {
    const sc_dt::sc_uint_base* at;
    int signal;
  };
  struct Inner {
    std::function<std::uint64_t()> read;
    int signal;
    int word;  ///< signal that has it as a word, or None
    const std::vector<std::string>* words;
  };

  void add_beam(bool with_clock);
  int add(const ChipSignal& signal);

  const TraceAxis& raster_;
  const std::uint64_t period_;
  const std::function<std::string(int)> part_;
  VcdWriter& vcd_;
  std::vector<Bit> bits_;
  std::vector<Word> words_;
  std::vector<Inner> inner_;
  int shown_ = None;  // frame whose part is written
  int line_bits_, frame_bits_;
  int clk_ = None, frame_ = None, line_ = None, pixel_ = None, clock_ = None, show_ = None;
};

}  // namespace racebeam
