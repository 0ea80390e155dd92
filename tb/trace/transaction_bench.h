// TransactionBench: the transaction-level chip with a display that tells of each write to it, run
// for a TransactionTrace.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "sc/beam/knobs.h"
#include "sc/beam/scene_program.h"
#include "tb/trace/transaction_trace.h"

namespace racebeam {

class TransactionBench {
 public:
  /// `program`: nullptr is the built-in demo. `raster` is that of the knobs. All of them and the
  /// trace outlive the bench.
  TransactionBench(const knobs& k, const scene_program* program, const Raster& raster,
                   TransactionTrace& trace);
  ~TransactionBench();

  /// Runs the frames of `window`, whole ones, until `stop` says so between two of them. Returns the
  /// clocks of the window that the trace has written. To be called once.
  std::int64_t run(const TraceWindow& window, const std::function<bool()>& stop);

 private:
  struct Platform;
  std::unique_ptr<Platform> platform_;
};

}  // namespace racebeam
