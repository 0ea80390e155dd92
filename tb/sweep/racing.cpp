// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/racing.h"

#include <fmt/format.h>

namespace racebeam {

std::vector<int> rungs(int sample) {
  std::vector<int> frames;
  for (int rung = FirstRung; rung < sample; rung *= 2)
    for (const int one : {rung, rung + rung / 2})
      if (4 * one <= 3 * sample) frames.push_back(one);
  frames.push_back(sample);
  return frames;
}

std::vector<Stop> stops(const std::vector<Candidate>& candidates, const std::vector<Goal>& goals,
                        int frames, double confidence) {
  std::vector<Stop> stopped;
  const std::vector<Verdict> verdicts = judge(candidates, goals, confidence);
  for (std::size_t point = 0; point < candidates.size(); ++point) {
    if (candidates[point].base) continue;
    const auto [standing, by] = verdicts[point];
    if (standing == Verdict::Dominated)
      stopped.push_back({point, by,
                         fmt::format("dominated by {} after {} frames",
                                     candidates[std::size_t(by)].name, frames)});
    if (standing == Verdict::Unwanted) {
      stopped.push_back({point, -1,
                         fmt::format("{} beyond its limit after {} frames",
                                     goals[std::size_t(by)].figure, frames)});
    }
  }
  return stopped;
}

}  // namespace racebeam
