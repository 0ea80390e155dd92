// BeamSound: the sound pin of whole frames, without the rest of the chip.
//
// The sound depends on the frame counter alone, so a viewer that leaves out frames can play it
// whole: pwm_sound's own core runs line by line, and each of its pulses becomes the mean level of
// its half line.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sc/beam/tlm/sound_line.h"
#include "tb/view/frame_source.h"

namespace racebeam {

class BeamSound {
 public:
  static_assert(SampleRate == FrameSource::SoundRate);

  /// FrameSamples samples of a frame, -1..1 around the mean level of what was played so far.
  std::vector<float> play(int frame);

 private:
  const line_raster raster_{knobs{}};
  pwm_sound_core core_;
  std::vector<pwm_change> changes_;
  double mean_ = 0;
  bool started_ = false;
};

}  // namespace racebeam
