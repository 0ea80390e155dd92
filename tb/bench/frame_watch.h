// FrameWatch: the picture at the beam, clock by clock, of any chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "tb/monitor/beam_screen.h"

namespace racebeam {

class FrameWatch {
 public:
  explicit FrameWatch(const Raster& raster) : raster_(raster), screen_(raster) {}
  virtual ~FrameWatch() = default;

  /// The next clock: the pins, and the number of the frame.
  void clock(int uo, int frame);
  /// The next clock is the first of a frame, wherever the last one was; the picture stays.
  void restart();

  /// Clocks of the frame that were seen; 0..clocks of a frame. The last whole frame stays until
  /// the first clock of the next.
  int seen() const { return seen_; }
  bool whole() const { return seen_ == raster_.frame_clocks(); }
  const Raster& raster() const { return raster_; }
  const BeamScreen& screen() const { return screen_; }
  /// Number of the frame at the beam.
  int frame() const { return frame_; }

 protected:
  /// A whole frame at once, before its first clock.
  void show(std::vector<std::uint8_t> colours, int frame);
  /// The frame is over.
  virtual void forget() { seen_ = 0; }

 private:
  const Raster raster_;
  BeamScreen screen_;
  int seen_ = 0, frame_ = 0;
};

}  // namespace racebeam
