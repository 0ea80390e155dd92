// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/guard_frames.h"

#include <algorithm>
#include <set>

namespace racebeam {

std::vector<int> worst_frames(std::vector<ScannedFrame> frames, int count) {
  std::set<int> worst;
  const auto add = [&](std::int64_t ScannedFrame::*number, int most) {
    std::sort(frames.begin(), frames.end(), [&](const ScannedFrame& a, const ScannedFrame& b) {
      return a.*number != b.*number ? a.*number > b.*number : a.frame < b.frame;
    });
    for (std::size_t i = 0; i < std::min<std::size_t>(std::size_t(most), frames.size()); ++i)
      worst.insert(frames[i].frame);
  };
  add(&ScannedFrame::busy_max, (count + 1) / 2);
  add(&ScannedFrame::starved, count / 2);
  return {worst.begin(), worst.end()};
}

}  // namespace racebeam
