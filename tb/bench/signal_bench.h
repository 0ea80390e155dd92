// The `signal` level of the interval tracer on the bench, with what only this chip has.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sc/base/unit_choices.h"
#include "sc/beam/scene_program.h"
#include "tb/bench/beam_watch.h"
#include "tb/bench/wired_bench.h"

namespace racebeam {

class SignalBench final : public WiredBench {
 public:
  struct Options {
    knobs k;
    bool stats = false;  ///< count
    bool crc = false;    ///< compute the CRCs of VgaFrame
    bool sound = false;  ///< listen to the PWM pin
    /// Instead of the built-in demo; must outlive the bench and fit the knobs.
    const scene_program* program = nullptr;
    unit_choices units{};        ///< models, RTL, or both in lockstep
    bool intervals = false;      ///< collect IntervalEvents
    BeamWatch* watch = nullptr;  ///< is told of every clock; must outlive the bench
  };

  /// Throws RtlError.
  explicit SignalBench(const Options& options);

  /// With the intervals, if they were asked for.
  Frame render() override;

 private:
  IntervalWatcher watcher_;
};

}  // namespace racebeam
