// LineWatcher: runs the chip through a line clock by clock and writes down its story.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "sc/beam/chip_core.h"
#include "tb/explain/line_story.h"

namespace racebeam {

class LineWatcher {
 public:
  /// `chip` has the knobs `k` and stands before the first clock of a line.
  LineWatcher(chip_core& chip, const knobs& k);

  /// Runs the chip to the end of the line, a visible one. `columns`: for each visible column, the
  /// clock in which a monitor samples it.
  LineStory watch(const std::vector<int>& columns);

 private:
  void observe_tracer(const chip_core& before, const chip_view& v);
  void offer(const chip_core& before, const chip_view& v);
  void take(const chip_core& before, const chip_view& v);
  void show(const chip_core& before, int uo);
  void keep_way();

  chip_core& chip_;
  const knobs knobs_;
  LineStory story_;
  int clock_ = 0;
  std::size_t column_ = 0;
  TracedInterval pending_{};                     // on offer
  int next_ = 0;                                 // first pixel that is not known
  std::size_t step_begin_ = 0;                   // first step since the interval before
  std::array<RoomOnWay, 1 << DepthBits> way_{};  // by depth, to where the tracer is
};

/// The story of one visible line of a frame: runs the frame up to that line first.
LineStory line_story(int frame, int y, const knobs& k, const scene_program* program);

}  // namespace racebeam
