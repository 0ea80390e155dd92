// WindowWriter: a window of a run, as the files that `racebeam trace` leaves.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tb/show.h"
#include "tb/trace/signal_trace.h"
#include "tb/trace/trace_run.h"

namespace racebeam {

struct WindowWriter {
  const Show& show;
  std::string output, picture;  ///< either may be empty
  TraceSelection selection;

  /// Goes from where the run stands to the window, and to its end, and says what was written. A run
  /// that the user stops keeps what there is. Returns the exit code. Throws UsageError as
  /// SignalTrace and TraceFiles do, and OutputError.
  int write(TraceRun& run, const TraceWindow& window) const;
};

}  // namespace racebeam
