// SignalTrace: the chip of a SignalBench as signals of a VCD, whatever its units are made of.
//
// A wire and the ports at its ends are one signal with several names: `chip.i2`,
// `chip.u_subdivider.i2_o`. Registers lie beside the ports of their unit, `chip.u_subdivider.i1_q`,
// at the same path in the model and in RTL; what RTL has besides joins them. In lockstep the RTL's
// side is `chip.u_subdivider.rtl`. States are words too: `chip.u_subdivider.state_q_name`. Where
// the beam is stands in `beam`.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tb/signal_bench.h"
#include "tb/trace/trace_window.h"
#include "tb/trace/vcd_writer.h"

namespace racebeam {

/// Which signals are wanted. Those of `beam` always are.
struct TraceSelection {
  std::vector<std::string> scopes;  ///< shell patterns of paths or of what holds them; none: all
  int depth = 0;                    ///< levels of the hierarchy, 1: the chip's own; 0: all

  bool takes(const std::string& path) const;
};

class SignalTrace {
 public:
  /// Adds the signals of `bench` to `vcd`; both outlive the trace. `part`: what a frame shows.
  /// Throws UsageError if nothing is selected.
  SignalTrace(SignalBench& bench, const Raster& raster, int period_ps,
              const TraceSelection& selection, std::function<std::string(int)> part,
              VcdWriter& vcd);

  /// The values of this clock, which the bench stands in.
  void sample(const TracePoint& at);

 private:
  struct Reading {
    int signal;
    std::function<std::uint64_t()> read;
    int word;  ///< signal that has it as a word, or None
    const std::vector<std::string>* words;
  };
  static constexpr int None = -1;

  void add_beam();
  void add_chip(const sc_core::sc_module& chip);
  void add_unit(const sc_core::sc_module& unit, const std::string& scope);
  void add_probes(const std::vector<probe>& probes, const std::string& scope);
  void add_wire(const std::string& scope, const std::string& name, int bits, wire_contents wire);
  void add_reading(const std::string& path, int bits, std::function<std::uint64_t()> read);

  SignalBench& bench_;
  const Raster& raster_;
  const std::uint64_t period_;
  const TraceSelection& selection_;
  const std::function<std::string(int)> part_;
  VcdWriter& vcd_;
  std::map<const void*, int> wires_;  // signals by what they carry
  std::vector<Reading> readings_;
  int shown_ = None;  // frame whose part is written
  int clk_ = None, frame_ = None, line_ = None, pixel_ = None, clock_ = None, show_ = None;
};

}  // namespace racebeam
