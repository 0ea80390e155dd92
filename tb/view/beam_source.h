// BeamSource: the interval tracer as a source of frames, at either level: what the viewer shows of
// it besides the picture.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/beam/knobs.h"
#include "tb/bench/beam_watch.h"
#include "tb/view/beam_sound.h"
#include "tb/view/frame_source.h"

namespace racebeam {

class BeamSource : public FrameSource {
 public:
  const BeamWatch& watch() const final { return watch_; }
  Rows rows() const final;
  std::vector<Gauge> gauges() const final;
  const std::vector<IntervalEvent>& intervals() const final { return watch_.intervals(); }
  std::vector<float> play(int frame) final;

 protected:
  explicit BeamSource(const knobs& k) : knobs_(k), watch_(Raster(k.clocks_per_pixel, k.speed)) {}

  const knobs knobs_;
  BeamWatch watch_;

 private:
  BeamSound sound_;
};

}  // namespace racebeam
