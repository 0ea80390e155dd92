// IntervalLog: the intervals of the visible lines as the transaction-level chip tells of them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/beam/tlm/chip_observer.h"
#include "tb/bench/interval_event.h"

namespace racebeam {

class IntervalLog final : public chip_observer {
 public:
  void started(int, int) override {}
  void entered(int, int, int, int) override {}
  void interval(const taken_interval& taken) override;
  void restart(int, int, int) override {}
  void shown(int, int, int, int) override {}
  void line_end(int y, int decisions) override;

  /// As IntervalWatcher::take().
  std::vector<IntervalEvent> take();

 private:
  std::vector<IntervalEvent> events_;
  int next_ = 0;       // first pixel of the line that is not known
  int decisions_ = 0;  // of the line, up to the last interval
};

}  // namespace racebeam
