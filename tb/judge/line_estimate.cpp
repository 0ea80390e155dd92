// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/line_estimate.h"

#include <algorithm>
#include <vector>

#include "sc/beam/tlm/line_raster.h"
#include "tb/base/spread_frames.h"
#include "tb/golden/tracer_4.h"

namespace racebeam {

namespace {

// Least squares over the 34,560 lines of 12 frames of each of the six scenes of our own, against
// the busy clocks of the cores with nothing to hurry for (hurry_threshold = -1, 8 clocks a pixel,
// 64 FIFO entries): correlation 0.9993, mean error of a line 2.0 %; of the worst line of a frame
// 1.4 %, at most 12 %, of the scene's worst among those frames at most 2.2 %. A question is asked
// at two ends and taken back later. Intervals, rooms and restarts as further terms move the mean
// error by 0.5 % and are left out; so is what the chip's cut products change.
constexpr double QuestionClocks = 2.21;
constexpr double ProbeClocks = 1.56;
constexpr int CameraClocks = 70;

// Some frames and lines first, then from the worst of these frames on to worse neighbours, then
// all lines of the last. In the six scenes that finds the worst line of all frames within 0.5 %;
// the first frames alone, with all lines, are up to 11 % below it.
constexpr int Frames = 128;
constexpr int Starts = 4;
constexpr int FirstLines = 8, ClimbLines = 2;  // every so many

int clocks(const TraceWork& work) {
  return static_cast<int>(QuestionClocks * work.questions + ProbeClocks * work.probes);
}

bool worse(const LineEstimate& a, const LineEstimate& b) { return a.clocks > b.clocks; }

/// To a frame near `start` that is worse than its neighbours, first in steps of about half of
/// `apart`.
LineEstimate climb(const Show& show, const knobs& k, int start, int apart) {
  LineEstimate worst = estimate_frame(show, start, k, ClimbLines);
  for (int step = apart; step > 1;) {
    step = (step + 1) / 2;
    for (const int frame : {worst.frame - step, worst.frame + step})
      if (frame >= 0 && frame < show.frames())
        worst = std::max(worst, estimate_frame(show, frame, k, ClimbLines),
                         [](const auto& a, const auto& b) { return worse(b, a); });
  }
  return worst;
}

}  // namespace

LineEstimate estimate_frame(const Show& show, int frame, const knobs& k, int lines) {
  const GoldenWorld world = show.golden_world(frame, k);
  const GoldenCamera camera = show.golden_camera(frame, k);
  LineEstimate worst;
  worst.frame = frame;
  for (int y = FirstVisibleLine; y < FirstVisibleLine + VisibleRows; y += lines) {
    const TraceWork work = trace_4_work(world, camera.rays(y), y, k.interval_stack_depth);
    if (clocks(work) > worst.clocks) worst = {clocks(work), work.intervals, frame, y};
  }
  return worst;
}

int LineEstimate::budget(const knobs& k) {
  return line_raster(k).size() - CameraClocks - k.head_start;
}

LineEstimate estimate_worst_line(const Show& show, const knobs& k) {
  std::vector<LineEstimate> coarse;
  for (const int frame : spread_frames(show.frames(), Frames))
    coarse.push_back(estimate_frame(show, frame, k, FirstLines));
  std::stable_sort(coarse.begin(), coarse.end(), worse);
  const int apart = std::max(2, show.frames() / Frames);
  LineEstimate worst;
  for (std::size_t i = 0; i < std::min<std::size_t>(Starts, coarse.size()); ++i) {
    const LineEstimate line = climb(show, k, coarse[i].frame, apart);
    if (worse(line, worst)) worst = line;
  }
  return estimate_frame(show, worst.frame, k);
}

}  // namespace racebeam
