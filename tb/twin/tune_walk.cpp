// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/tune_walk.h"

#include "sc/base/constants.h"

namespace racebeam {

namespace {

constexpr int LineClocks = 2 * TuneWalk::SampleClocks;
constexpr int FirstColumn = -960;  // x2 where a line begins

}  // namespace

void TuneWalk::next() {
  if (clock_ % SampleClocks == 0) next_step(clock_ / SampleClocks);
  bench_["rst_ni"].drive(clock_ > 0);
  bench_["x2_i"].drive((FirstColumn + clock_ % LineClocks) & low_bits(bench_["x2_i"].bits));
  ++clock_;
}

// The edges of a step are where notes begin, fade and end.
void TuneWalk::next_step(int step) {
  int frame = below(tune::StepFrames), line = below(FrameLines);
  switch (below(3)) {
    case 0: frame = line = 0; break;
    case 1: frame = tune::StepFrames - 1, line = FrameLines - 1; break;
    default: break;
  }
  bench_["frame_i"].drive(step * tune::StepFrames + frame);
  bench_["y_i"].drive((FirstLine + line) & low_bits(bench_["y_i"].bits));
}

}  // namespace racebeam
