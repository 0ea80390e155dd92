// TileWave: the pins of a Tiny Tapeout chip while its frames are rendered, as a waveform.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "tb/trace/signal_trace.h"
#include "tb/trace/tile_run.h"
#include "tb/trace/trace_files.h"

namespace racebeam {

class TileWave {
 public:
  /// Begins with frame `first` of a run that stands at its reset, and follows it from there; `run`
  /// outlives it. Throws OutputError.
  TileWave(TtRun& run, const std::string& name, int first, const std::string& path);

  /// Ends the file after the clocks so far; without one there is no file. Throws OutputError.
  void commit();

 private:
  TileRun run_;
  VcdWriter vcd_;
  SignalTrace trace_;
  TraceFiles files_;
  const std::int64_t first_;
  std::int64_t next_;
};

}  // namespace racebeam
