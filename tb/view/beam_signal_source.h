// SignalSource: the wired SystemC chip, with whatever RTL is in it, as the source of frames.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/bench/signal_bench.h"
#include "tb/view/beam_source.h"

namespace racebeam {

/// One per process.
class SignalSource : public BeamSource {
 public:
  /// The program, if any, must outlive the source and fit the knobs. Throws RtlError.
  SignalSource(const knobs& k, const scene_program* program, const unit_choices& units);

  const char* level() const override { return "signal"; }
  bool fast() const override { return false; }
  void seek(int frame) override;
  /// Throws SyncError.
  int advance(int clocks) override;

 private:
  SignalBench bench_;
};

}  // namespace racebeam
