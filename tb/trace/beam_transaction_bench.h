// TransactionBench: the transaction-level chip with a display that tells of each write to it, run
// for a TransactionTrace of its own.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "sc/beam/knobs.h"
#include "sc/beam/scene_program.h"
#include "tb/trace/beam_transaction_trace.h"
#include "tb/trace/framed_run.h"

namespace racebeam {

class TransactionBench final : public FramedRun {
 public:
  /// `program`: nullptr is the built-in demo. `raster` is that of the knobs. Both and `vcd` outlive
  /// the bench. `part` and the selection are as for TransactionTrace, which throws UsageError.
  TransactionBench(const knobs& k, const scene_program* program, const Raster& raster,
                   const TraceSelection& selection, std::function<std::string(int)> part,
                   VcdWriter& vcd);
  ~TransactionBench() override;

  std::int64_t run(const TraceWindow& window, const std::function<bool()>& stop) override;

 private:
  struct Platform;
  std::unique_ptr<Platform> platform_;
};

}  // namespace racebeam
