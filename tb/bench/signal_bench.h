// The `signal` level on the bench: the SystemC chip between a clock, its input pins and monitors.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "sc/base/unit_choices.h"
#include "sc/beam/scene_program.h"
#include "tb/bench/chip_bench.h"
#include "tb/bench/frame_watch.h"

namespace racebeam {

class SignalBench final : public ChipBench {
 public:
  struct Options {
    knobs k;
    bool stats = false;  ///< collect frame_stats
    bool crc = false;    ///< compute the CRCs of VgaFrame
    bool sound = false;  ///< listen to the PWM pin
    /// Instead of the built-in demo; must outlive the bench and fit the knobs.
    const scene_program* program = nullptr;
    unit_choices units{};         ///< models, RTL, or both in lockstep
    bool intervals = false;       ///< collect IntervalEvents
    FrameWatch* watch = nullptr;  ///< is told of every clock; must outlive the bench
    bool outlive_faults = false;  ///< of RTL in lockstep: the chip goes on without it
  };

  /// Throws RtlError.
  explicit SignalBench(const Options& options);
  ~SignalBench() override;

  /// Not in the middle of a frame.
  void seek(int frame) override;
  /// Simulates so many clocks, to the end of the frame at most. Throws SyncError, what
  /// each_clock()'s `look` throws, RtlFault, and Interrupted between two lines.
  void advance(int clocks);
  /// One frame, or the rest of one.
  Frame render() override;
  /// Lets all wires settle without a clock: after seek(), and after construction, they have not.
  void settle();
  /// From now on `look` is called in every clock once its wires have settled, beginning with the
  /// clock that the bench stands in; an empty one ends that. Without one there is no cost. After
  /// an exception it is called no more.
  void each_clock(std::function<void()> look);
  /// From the next line on all registers follow every clock, which costs an eighth of the speed.
  void watch_registers();
  /// Lockstep begins anew: differences so far are no first ones.
  void forget_differences();
  /// The chip, to be looked into between clocks.
  const sc_core::sc_module& dut() const;
  /// Of a clock, in picoseconds.
  int period_ps() const;
  std::uint64_t clocks() const override;
  const SoundMonitor* sound() const override;
  std::vector<const Lockstep*> locksteps() const override;

 private:
  struct Platform;
  std::unique_ptr<Platform> platform_;
};

}  // namespace racebeam
