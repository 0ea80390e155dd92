// FrameSequence: frames in order, rendered by this process, or by several others.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "tb/render/frame_workers.h"

namespace racebeam {

class FrameSequence {
 public:
  using Render = FrameWorkers::Render;

  /// `prepare` is called once in each process that renders: this one for one job.
  FrameSequence(int jobs, int frames, const std::function<Render()>& prepare) {
    if (jobs > 1) workers_.emplace(jobs, frames, prepare);
    else render_ = prepare();
  }

  /// Throws what rendering throws. Nothing: an interrupt came before the frame was whole.
  std::optional<RenderedFrame> next() {
    return workers_ ? workers_->next() : std::optional(render_(index_++));
  }

 private:
  std::optional<FrameWorkers> workers_;
  Render render_;
  int index_ = 0;
};

}  // namespace racebeam
