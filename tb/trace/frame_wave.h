// FrameWave: ports and wires of the chip while frames are rendered, as a waveform.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/show/show.h"
#include "tb/trace/signal_trace.h"
#include "tb/trace/trace_files.h"

namespace racebeam {

class FrameWave {
 public:
  /// Begins with frame `first`, which the bench is put to, and follows it from there; `bench` and
  /// `show` outlive it. Throws OutputError.
  FrameWave(WiredBench& bench, const Show& show, const Raster& raster, int first,
            const std::string& path);

  /// Ends the file after the clocks so far; without one there is no file. Throws OutputError.
  void commit();

 private:
  WiredBench& bench_;
  const TraceAxis raster_;
  VcdWriter vcd_;
  SignalTrace trace_;
  TraceFiles files_;
  const std::int64_t first_;
  std::int64_t next_;
};

}  // namespace racebeam
