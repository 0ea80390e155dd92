// Condition: an expression over the signals of the chip, such as
// `u_subdivider.sd_q == 4 && line == 240`.
//
// A signal is named by its path, with or without `chip.` or `beam.`; words of states are numbers
// (`u_subdivider.state_q == bisect`). Operators are those of C on numbers (! - * / + < <= > >= ==
// != && || ?:), and bit(x, n). Signed signals are signed. The parser is muParser: numbers are
// doubles, exact up to 53 bits.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "tb/raster.h"
#include "tb/signal_bench.h"

namespace racebeam {

class Condition {
 public:
  /// Throws UsageError that names the place: no such signal, not an expression, no signal at all.
  /// `bench` and `raster` outlive it.
  Condition(const std::string& text, const SignalBench& bench, const Raster& raster);
  ~Condition();

  /// Whether it is not 0 in the clock of this ordinal, in which the bench has settled.
  bool holds(std::int64_t clock);

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace racebeam
