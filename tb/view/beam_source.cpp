// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/beam_source.h"

#include "sc/base/constants.h"
#include "sc/beam/counters.h"

namespace racebeam {

FrameSource::Rows BeamSource::rows() const {
  const frame_counts counts = counted(watch_.stats());
  Rows rows;
  for (std::size_t n = 0; n < counts.counters.size(); ++n)
    if (const char* title = counter_table()[n].info.title; *title)
      rows.emplace_back(title, std::to_string(counts.counters[n]));
  return rows;
}

std::vector<Gauge> BeamSource::gauges() const {
  const chip_view& now = watch_.now();
  const frame_stats& stats = watch_.stats();
  const auto counts = [](const auto& histogram) {
    return std::vector<std::uint64_t>(histogram.begin(), histogram.end());
  };
  return {{"FIFO entries", counts(stats.fifo_fill), knobs_.fifo_entries, now.fill, now.starving},
          {"interval stack", counts(stats.stack_depth), knobs_.interval_stack_depth, now.sd, false},
          {"rooms entered",
           {},
           knobs_.room_depth_limit(),
           now.tag >> LevelBits & ((1 << DepthBits) - 1),
           false}};
}

// The pin is clocked by the beam: other clocks a pixel would make other tones.
std::vector<float> BeamSource::play(int frame) {
  const knobs chip;
  if (knobs_.clocks_per_pixel != chip.clocks_per_pixel || knobs_.speed != chip.speed) return {};
  return sound_.play(frame);
}

}  // namespace racebeam
