// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/tune_walk.h"

#include <iterator>

#include "sc/base/constants.h"

namespace racebeam {

namespace {

constexpr int LineClocks = 2 * TuneWalk::SampleClocks;
constexpr int FirstColumn = -960;  // x2 where a line begins, and sample A; 800 on sample B
constexpr int SlotClocks = 32, Voices = 24;
constexpr int Takes = 29, AddsHigh = 31;  // clocks of a voice's slot

// Times of the tune, in samples B, when drums are heard as in some mistake they are not, as
// racebeam signoff found: a kick by a sixteenth of a clock, and two waves cut at their highest.
constexpr struct { int frame, line; } Drums[] = {{0x480, 0x8}, {0x204d, 0x12a}, {0x1a3d, 0x12b}};
constexpr int FirstDrum = TuneWalk::Moments - static_cast<int>(std::size(Drums));

}  // namespace

void TuneWalk::next() {
  const int clock = clock_++, moment = clock - static_cast<int>(TuneClocks);
  const bool drum_next =
      moment % MomentClocks == MomentClocks - 1 && moment / MomentClocks + 1 >= FirstDrum;
  bench_["rst_ni"].drive(clock > 0 && !drum_next);
  if (moment < 0) {
    if (clock % SampleClocks == 0) next_step(clock / SampleClocks);
    return drive_x2(FirstColumn + clock % LineClocks);
  }
  if (moment % MomentClocks == 0) next_moment(moment / MomentClocks);
  drive_x2(moment_x2(moment % MomentClocks));
}

void TuneWalk::drive_x2(int x2) { bench_["x2_i"].drive(x2 & low_bits(bench_["x2_i"].bits)); }

void TuneWalk::drive_line(int line) {
  bench_["y_i"].drive((FirstLine + line) & low_bits(bench_["y_i"].bits));
}

// Any time of the tune or, seldom, after it; in the end drums, each after a reset: no tone has a
// wave then.
void TuneWalk::next_moment(int moment) {
  constexpr int MostSkipped = 64;
  if (moment >= FirstDrum) {
    const auto& [frame, line] = Drums[moment - FirstDrum];
    first_x2_ = FirstColumn + SampleClocks;
    bench_["frame_i"].drive(static_cast<std::uint64_t>(frame));
    return drive_line(line);
  }
  first_x2_ = FirstColumn + below(2) * SampleClocks;
  skipped_ = below(MostSkipped);
  bench_["speed_i"].drive(random_() & low_bits(bench_["speed_i"].bits));
  bench_["frame_i"].drive(below(8) == 0 ? random_() & low_bits(bench_["frame_i"].bits)
                                        : below(Steps * tune::StepFrames));
  drive_line(below(FrameLines));
}

// Of each voice the two clocks that count, then those of the end of a sample, then none.
int TuneWalk::moment_x2(int clock) const {
  if (clock < 2 * Voices)
    return first_x2_ + clock / 2 * SlotClocks + (clock % 2 == 0 ? Takes : AddsHigh);
  const int end_x2 = first_x2_ + Voices * SlotClocks, after = clock - 2 * Voices - skipped_;
  return after < 0 || after == 1 ? end_x2 + 1 : after == 0 ? end_x2 : first_x2_;
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
  drive_line(line);
}

}  // namespace racebeam
