// WindowWriter: a window of a run, as the files that `racebeam trace` leaves.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "tb/trace/clocked_run.h"
#include "tb/trace/framed_run.h"
#include "tb/trace/signal_trace.h"
#include "tb/trace/trace_files.h"
#include "tb/trace/trace_window.h"
#include "tb/wave/trace_size.h"

namespace racebeam {

struct WindowWriter {
  std::string name;                      ///< of what is shown
  std::function<std::string(int)> part;  ///< what a frame shows; empty: nobody knows
  std::string output, picture;           ///< either may be empty
  TraceSelection selection;

  /// Goes from where the run stands to the window, and to its end, and says what was written. A run
  /// that the user stops keeps what there is. Returns the exit code. Throws UsageError as
  /// SignalTrace and TraceFiles do, and OutputError.
  int write(ClockedRun& run, const TraceWindow& window) const;
  /// Throws what write() would throw before its first clock.
  void check(ClockedRun& run) const;
  /// As write(), of what `make` makes for a VCD: transactions, most of them short.
  int write_frames(const std::function<std::unique_ptr<FramedRun>(VcdWriter&)>& make,
                   const Raster& raster, int period_ps, const TraceWindow& window) const;

 private:
  struct Written {
    const TraceWindow& window;
    const Raster& raster;
    int period_ps;
    std::int64_t clocks;
    int readable;  ///< clocks that are to be wide enough to be read
  };
  /// Says how large a long one will be, and whether it fits.
  void announce(const TraceSize& size) const;
  int finish(TraceFiles& files, const VcdWriter& vcd, const Written& written) const;
};

}  // namespace racebeam
