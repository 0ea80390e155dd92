// LineProgress: a progress bar over the lines of a ClockedRun.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "tb/base/progress.h"
#include "tb/trace/clocked_run.h"

namespace racebeam {

class LineProgress {
 public:
  /// From where `run`, which outlives this, stands to the clock `last`; `note` goes with the bar.
  LineProgress(ClockedRun& run, std::int64_t last, std::function<std::string()> note)
      : run_(run), bar_((last - run.clock()) / run.raster().line_clocks() + 1, "lines") {
    run.each_line([this, begin = run.clock(), note = std::move(note)](std::int64_t clock) {
      const std::int64_t clocks = clock - begin;
      bar_.draw(clocks / run_.raster().line_clocks(), static_cast<std::uint64_t>(clocks), note());
    });
  }
  /// Removes the bar for good.
  ~LineProgress() { end(); }
  LineProgress(const LineProgress&) = delete;
  LineProgress& operator=(const LineProgress&) = delete;
  void end() {
    run_.each_line({});
    bar_.clear();
  }

 private:
  ClockedRun& run_;
  Progress bar_;
};

}  // namespace racebeam
