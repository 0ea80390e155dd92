// Condition: an expression over the signals of the chip, such as
// `u_subdivider.sd_q == 4 && line == 240`.
//
// A signal is named by its path, with or without `chip.` or `beam.`, or by its last name if no
// other has that; signed ones are signed. Behind `==` or `!=` a state register is compared with its
// words: `u_subdivider.state_q == bisect`. The operators are those of Expression.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tb/trace/chip_signals.h"
#include "tb/trace/trace_axis.h"

namespace racebeam {

class Condition {
 public:
  /// Throws UsageError that names the place: no such signal or state, not an expression, no signal
  /// at all. The registers of a bench are to be watched. `raster` outlives it.
  Condition(const std::string& text, std::vector<ChipSignal> signals, const TraceAxis& raster);
  ~Condition();

  /// Whether it is not 0 in the clock of this ordinal, in which the bench has settled.
  bool holds(std::int64_t clock);

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace racebeam
