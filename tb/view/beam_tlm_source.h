// TlmSource: the cores of the tlm level as the source of frames: whole ones line by line, others
// clock by clock. Can be flown freely.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "sc/beam/tlm/chip_lines.h"
#include "tb/bench/interval_log.h"
#include "tb/view/beam_source.h"

namespace racebeam {

class TlmSource : public BeamSource {
 public:
  /// The demo, or a program that fits the knobs and outlives the source. `wraps`: its corners are
  /// meant to wrap at the knob's width, which a free flight must not widen.
  explicit TlmSource(const knobs& k, const scene_program* program = nullptr, bool wraps = true);

  const char* level() const override { return "tlm"; }
  bool fast() const override { return true; }
  void seek(int frame) override;
  int advance(int clocks) override;
  bool can_fly() const override { return program_ != nullptr; }
  void fly(int frame, const Pose& pose) override;

 private:
  void restart();
  chip_core& chip() { return lines_->registers(); }
  void run_frame();

  const scene_program* const program_;
  const bool wraps_;
  knobs now_;  // wider in a free flight
  IntervalLog log_;
  std::optional<chip_lines> lines_;
  bool flying_ = false;
};

}  // namespace racebeam
