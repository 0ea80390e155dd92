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
  const int clock = clock_++;
  if (clock >= static_cast<int>(TuneClocks))
    return count_phase(clock - static_cast<int>(TuneClocks));
  if (clock % SampleClocks == 0) next_step(clock / SampleClocks);
  bench_["rst_ni"].drive(clock > 0);
  drive_x2(FirstColumn + clock % LineClocks);
}

void TuneWalk::drive_x2(int x2) { bench_["x2_i"].drive(x2 & low_bits(bench_["x2_i"].bits)); }

// From a reset on it stays where the low half is counted, until that wraps, then where each clock
// adds the carry to the high half.
void TuneWalk::count_phase(int clock) {
  constexpr int EndOfSample = -192, LowHalf = 1024;
  bench_["rst_ni"].drive(clock > 0);
  drive_x2(clock <= LowHalf ? EndOfSample : EndOfSample + 1);
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
