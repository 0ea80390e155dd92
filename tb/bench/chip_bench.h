// ChipBench: a chip of any engine on the bench at some level, frame by frame; a chip that does not
// race the beam, picture by picture.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sc/base/frame_counts.h"
#include "tb/bench/interval_event.h"
#include "tb/monitor/sound_monitor.h"
#include "tb/monitor/vga_monitor.h"
#include "tb/twin/lockstep.h"

namespace racebeam {

/// What an engine that does not race the beam took for a picture.
struct PictureTime {
  std::uint64_t clocks = 0;  ///< from its start to its end
  std::uint64_t frames = 0;  ///< of the raster that began meanwhile
};

/// One simulation of the demo or a program. SystemC elaborates once: one bench per process.
class ChipBench {
 public:
  struct Frame {
    int number;  ///< value of the frame counter while its lines are shown; or of a picture
    VgaFrame picture;
    std::optional<frame_counts> stats;       ///< if they were asked for
    std::vector<IntervalEvent> intervals{};  ///< if they were asked for
    PictureTime time{};                      ///< of an engine that does not race the beam
  };

  virtual ~ChipBench() = default;

  /// The next frame to render; 0 after construction. Nothing between is simulated: only
  /// the frame counter and the navigator carry state from frame to frame.
  virtual void seek(int frame) = 0;
  /// Simulates one frame; the next is the following one. Throws SyncError.
  virtual Frame render() = 0;
  /// Clocks simulated so far.
  virtual std::uint64_t clocks() const = 0;
  /// What the PWM pin played so far; nullptr if not asked for.
  virtual const SoundMonitor* sound() const = 0;
  /// The units that run in lockstep, in the order of the chip.
  virtual std::vector<const Lockstep*> locksteps() const { return {}; }
};

}  // namespace racebeam
