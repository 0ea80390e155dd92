// FrameRenderer: makes the frames of a plan with the chip, one by one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "tb/bench/chip_bench.h"
#include "tb/render/render_options.h"
#include "tb/render/rendered_frame.h"
#include "tb/trace/frame_wave.h"

namespace racebeam {

class FrameRenderer {
 public:
  /// `plan` must outlive it; with `sound`, the PWM pin is heard. One per process, as of any
  /// ChipBench. Throws RtlError.
  FrameRenderer(const RenderPlan& plan, bool sound);

  /// The `index`-th frame of the plan, with its files if there is a folder. Throws SyncError.
  RenderedFrame render(int index);

  /// Ends the waveform, if there is one. Throws OutputError.
  void finish();

  const ChipBench& bench() const { return *bench_; }

 private:
  const RenderPlan& plan_;
  std::unique_ptr<ChipBench> bench_;
  std::unique_ptr<FrameWave> wave_;
};

}  // namespace racebeam
