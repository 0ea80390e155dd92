// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/scene_notes.h"

#include <utility>

#include "tb/bench/core_bench.h"

namespace racebeam {

void FrameCounter::add(int frame, std::uint64_t value) {
  sum += value;
  if (value <= worst) return;
  worst = value;
  worst_frame = frame;
}

SceneNotes::SceneNotes(Show show, const knobs& k)
    : show_(std::move(show)), knobs_(k), estimate_(estimate_worst_line(show_, k)) {}

void SceneNotes::add(int frame) {
  const CoreBench::Frame chip = CoreBench(knobs_, frame, show_.program()).render();
  frames_.push_back(frame);
  busy_clocks_.add(frame, chip.stats.busy_clocks);
  restarts_.add(frame, chip.stats.restarts);
  starved_pixels_.add(frame, chip.stats.starved_pixels);
  give_ups_.add(frame, chip.stats.give_ups);
  golden_ += golden_compare(show_, frame, knobs_, chip.colours).counts;
}

}  // namespace racebeam
