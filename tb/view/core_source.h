// CoreSource: the cores in one loop as the source of frames; can be flown freely.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/chip_core.h"
#include "tb/view/frame_source.h"

namespace racebeam {

class CoreSource : public FrameSource {
 public:
  /// The demo, or a program that fits the knobs and outlives the source. `wraps`: its corners are
  /// meant to wrap at the knob's width, which a free flight must not widen.
  explicit CoreSource(const knobs& k, const scene_program* program = nullptr, bool wraps = true);

  const char* level() const override { return "core"; }
  bool fast() const override { return true; }
  const FrameWatch& watch() const override { return watch_; }
  void seek(int frame) override;
  int advance(int clocks) override;
  bool can_fly() const override { return program_ != nullptr; }
  void fly(int frame, const Pose& pose) override;

 private:
  void restart();

  const knobs knobs_;
  const scene_program* const program_;
  const bool wraps_;
  knobs now_;  // wider in a free flight
  chip_core chip_;
  FrameWatch watch_;
  bool flying_ = false;
};

}  // namespace racebeam
