// The `signal` level on the bench: the SystemC chip between a clock, its input pins and monitors.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "sc/scene_program.h"
#include "sc/unit_choices.h"
#include "tb/frame_stats.h"
#include "tb/lockstep.h"
#include "tb/sound_monitor.h"
#include "tb/vga_monitor.h"
#include "tb/view/frame_watch.h"

namespace racebeam {

/// One simulation of the demo or a program, frame by frame. SystemC elaborates once: one bench per
/// process.
class SignalBench {
 public:
  struct Options {
    knobs k;
    bool stats = false;  ///< collect FrameStats
    bool crc = false;    ///< compute the CRCs of VgaFrame
    bool sound = false;  ///< listen to the PWM pin
    /// Instead of the built-in demo; must outlive the bench and fit the knobs.
    const scene_program* program = nullptr;
    unit_choices units{};         ///< models, RTL, or both in lockstep
    bool intervals = false;       ///< collect IntervalEvents
    FrameWatch* watch = nullptr;  ///< is told of every clock; must outlive the bench
  };
  struct Frame {
    int number;  ///< value of the frame counter while its lines are shown
    VgaFrame picture;
    std::optional<FrameStats> stats;
    std::vector<IntervalEvent> intervals;
  };

  /// Throws RtlError.
  explicit SignalBench(const Options& options);
  ~SignalBench();

  /// The next frame to render; 0 after construction. Not in the middle of a frame. Nothing between
  /// is simulated: only the frame counter and the navigator carry state from frame to frame.
  void seek(int frame);
  /// Simulates so many clocks, to the end of the frame at most. Throws SyncError.
  void advance(int clocks);
  /// Simulates one frame, or the rest of one; the next is the following one. Throws SyncError.
  Frame render();
  /// Clocks simulated so far.
  std::uint64_t clocks() const;
  /// The units that run in lockstep, in the order of the chip.
  std::vector<const Lockstep*> locksteps() const;
  /// What the PWM pin played so far; nullptr if not asked for.
  const SoundMonitor* sound() const;

 private:
  struct Platform;
  std::unique_ptr<Platform> platform_;
};

}  // namespace racebeam
